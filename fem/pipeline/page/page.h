#pragma once

#include <nlohmann/json.hpp>

#include <map>
#include <string>

/// Page of results: HTML, style and script of page/ with an embedded document. Pictures, tables and
/// surrounding sentences are made in the browser.
namespace stemware::pipeline
{

/// Returns report.html, a self-contained page. @p title and @p answer are also included as text, for browsers
/// without scripts.
std::string report_page(const nlohmann::ordered_json &document, const std::string &title,
                        const std::string &answer);

/// Returns the live page. @p parts: ANSWER as HTML, for browsers without scripts; DATA, JSON within HTML;
/// BODIES, WASM and GLUE, gzip in base64.
std::string live_page(std::map<std::string, std::string> parts);

} // namespace stemware::pipeline
