#pragma once

#include <nlohmann/json.hpp>

#include <map>
#include <string>

/// The page of results: HTML, style and script of page/, with a document in them. All pictures, tables and
/// sentences around them are made in the browser.
namespace stemware::pipeline
{

/// Returns report.html: one page that needs nothing else. @p title and @p answer stand in it as text too, for
/// a browser that runs no script.
std::string report_page(const nlohmann::ordered_json &document, const std::string &title,
                        const std::string &answer);

/// Returns the page that solves again at every move of a slider. @p parts are its ANSWER as HTML, for a
/// browser that runs no script; its DATA, JSON within HTML; and its BODIES, WASM and GLUE, gzip in base64.
std::string live_page(std::map<std::string, std::string> parts);

} // namespace stemware::pipeline
