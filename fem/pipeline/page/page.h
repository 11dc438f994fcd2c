#pragma once

#include <nlohmann/json.hpp>

#include <optional>
#include <string>

/// The page of results: HTML, style and script of page/ with an embedded document. Pictures, tables and
/// surrounding sentences are made in the browser.
namespace stemware::pipeline
{

/// Solver and compliances of a page that solves again at every move of a slider.
struct LivePart
{
  nlohmann::ordered_json data; ///< pairs of glass and table with their studies
  std::string bodies, wasm;    ///< compliances and solver, gzip in base64
};

/// Returns a self-contained page of @p document; null: without one. @p title and @p answer are also included
/// as text, for browsers without scripts.
std::string page_of(const nlohmann::ordered_json &document, const std::string &title,
                    const std::string &answer, const std::optional<LivePart> &live = {});

} // namespace stemware::pipeline
