#pragma once

#include <optional>
#include <string>
#include <vector>

namespace stemware::pipeline
{

/// Nothing that is printed on the console is wider than this.
constexpr std::size_t console_width = 100;

/// Breaks a text between words into lines that fit the console. @p label stands before the first line, and
/// blanks as wide before the others; lines are at most @p width columns wide. A number stays on one line
/// with a % or rad/s behind it.
std::string wrapped(const std::string &text, const std::string &label = "",
                    std::size_t width = console_width);

/// Columns of the screen that a text takes: the bytes that begin a character of UTF-8.
std::size_t display_width(const std::string &text);

/// "a, b or c": the words with commas between them, and @p last before the last one.
std::string listed(const std::vector<std::string> &words, const std::string &last = "or");

/// @p pattern with each "{}" replaced by the next one of @p words.
std::string filled(const std::string &pattern, const std::vector<std::string> &words);

/// The closest of @p words to @p word by edit distance (letters to insert, delete or change; upper and lower
/// case are equal), if one is at most 3 away.
std::optional<std::string> closest_match(const std::string &word, const std::vector<std::string> &words);

} // namespace stemware::pipeline
