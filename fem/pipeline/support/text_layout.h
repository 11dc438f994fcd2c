#pragma once

#include <cstdio>
#include <optional>
#include <string>
#include <vector>

namespace stemware::pipeline
{

/// Nothing that is printed for people is wider than this.
constexpr std::size_t console_width = 100;

/// printf into a string: columns and digits at a glance.
template <typename... Values>
std::string formatted(const char *format, Values... values)
{
  std::string text(static_cast<std::size_t>(std::snprintf(nullptr, 0, format, values...)) + 1, ' ');
  std::snprintf(text.data(), text.size(), format, values...);
  text.pop_back();
  return text;
}

/// A number in printf's @p format, or @p none where there is none.
inline std::string formatted_or(const std::string &none, const char *format,
                                const std::optional<double> &value)
{
  return value ? formatted(format, *value) : none;
}

/// A share with its sign in per cent to three digits, "+0.274 %"; "-" where there is none.
std::string in_percent(const std::optional<double> &share);

/// Breaks a text between words into lines that fit the console. @p label stands before the first line, and
/// blanks as wide before the others.
std::string wrapped(const std::string &text, const std::string &label = "");

/// One column of a table on the console.
struct TextColumn
{
  std::string header;             ///< may have several lines: "terminal spin\n(rad/s)"
  std::vector<std::string> cells; ///< as many as the other columns have
  bool is_text = false;           ///< words to the left, numbers to the right
};

/// The lines of a table that fits the console, each with its line break: columns that have no room follow
/// below, beside the first column again.
std::string text_table(const std::vector<TextColumn> &columns);

} // namespace stemware::pipeline
