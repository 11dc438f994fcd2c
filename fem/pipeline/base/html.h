#pragma once

#include <map>
#include <string>

/// Texts of HTML pages.
namespace stemware::pipeline
{

/// Replaces each mark /*NAME*/ of @p text by the text of that name, in one pass: inserted marks are not
/// replaced.
std::string with_marks_replaced(const std::string &text, const std::map<std::string, std::string> &texts);

/// Returns @p text escaped for HTML elements and quoted attributes.
std::string html_text(const std::string &text);

/// Returns the base64 form of a number in hexadecimal @p digits, as a Content-Security-Policy has check sums.
std::string base64_of_digits(const std::string &digits);

} // namespace stemware::pipeline
