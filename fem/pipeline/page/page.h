#pragma once

#include <nlohmann/json.hpp>

#include <map>
#include <string>

/// The page of results: HTML, style and script of page/, with a document in them. All pictures, tables and
/// sentences around them are made in the browser.
namespace stemware::pipeline
{

/// Replaces each mark /*NAME*/ of @p text by the text of that name, in one pass: marks within the texts stay
/// as they are.
std::string with_marks_replaced(const std::string &text, const std::map<std::string, std::string> &texts);

/// A text without what means something to HTML, in elements and in quoted attributes.
std::string html_text(const std::string &text);

/// The base64 form of a number in hexadecimal digits, as a Content-Security-Policy has check sums.
std::string base64_of_digits(const std::string &digits);

/// Returns report.html: one page that needs nothing else. @p title and @p answer stand in it as text too, for
/// a browser that runs no script.
std::string report_page(const nlohmann::ordered_json &document, const std::string &title,
                        const std::string &answer);

} // namespace stemware::pipeline
