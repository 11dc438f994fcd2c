#pragma once

#include "fem/pipeline/base/json.h"

#include <string>

/// Pages: HTML, style and script of page/ with an embedded document of results or solver. The browser makes
/// pictures, tables and surrounding sentences.
namespace stemware::pipeline
{

/// Solver and compliances of a page that solves a study at every move of a slider.
struct LivePart
{
  Json data;                ///< pairs of glass and table with their studies
  std::string bodies, wasm; ///< compliances and solver, gzip in base64
};

/// Returns a self-contained page of @p document, with @p title and @p answer for browsers without scripts.
std::string page_of(const Json &document, const std::string &title, const std::string &answer);

/// Returns a self-contained page that solves @p live.
std::string live_page(const LivePart &live, const std::string &title, const std::string &answer);

} // namespace stemware::pipeline
