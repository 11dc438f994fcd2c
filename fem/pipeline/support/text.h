#pragma once

#include <optional>
#include <string>
#include <vector>

namespace stemware::pipeline
{

/// Nothing that is printed on the console is wider than this.
constexpr std::size_t console_width = 100;

/// A share with its sign in per cent to three digits, "+0.274 %"; "-" where there is none.
std::string in_percent(const std::optional<double> &share);

/// Breaks a text between words into lines that fit the console. @p label stands before the first line, and
/// blanks as wide before the others; lines are at most @p width columns wide.
std::string wrapped(const std::string &text, const std::string &label = "",
                    std::size_t width = console_width);

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

/// One line of a table as RFC 4180 has it: commas, CRLF, fields with commas, quotes or line ends in double
/// quotes.
std::string csv_record(const std::vector<std::string> &fields);

/// "name (unit)", or the name alone where there is no unit.
std::string column_title(const std::string &name, const std::string &unit);

/// The closest of @p words to @p word by edit distance (letters to insert, delete or change; upper and lower
/// case are equal), if one is at most 3 away.
std::optional<std::string> likeliest(const std::string &word, const std::vector<std::string> &words);

} // namespace stemware::pipeline
