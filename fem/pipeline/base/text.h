#pragma once

#include <optional>
#include <string>
#include <vector>

namespace stemware::pipeline
{

/// Width of the console's text [columns].
constexpr std::size_t console_width = 100;

/// Wraps a text into lines of at most @p width columns; @p label precedes the first line, blanks of its width
/// the others. A number and a following % or rad/s are not separated.
std::string wrapped(const std::string &text, const std::string &label = "",
                    std::size_t width = console_width);

/// Returns the number of columns of a text: its UTF-8 characters.
std::size_t display_width(const std::string &text);

/// Returns "a, b or c": the words separated by commas, with @p last before the last word.
std::string listed(const std::vector<std::string> &words, const std::string &last = "or");

/// Returns @p pattern with each "{}" replaced by the next of @p words.
std::string filled(const std::string &pattern, const std::vector<std::string> &words);

/// Returns @p text as a CSV field, quoted if it has a comma, quotation mark, line end or # (often a comment).
std::string csv_field(const std::string &text);

/// Returns the word closest to @p word, ignoring case; std::nullopt if the edit distance exceeds 3.
std::optional<std::string> closest_match(const std::string &word, const std::vector<std::string> &words);

} // namespace stemware::pipeline
