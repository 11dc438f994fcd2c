#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>

namespace stemware::pipeline
{

/// Returns the shortest decimal text that reads back as the same double: 0.03, 7e10, 3e-4; "nan" for any NaN.
std::string to_text(double value);

/// Returns @p value with at most six significant digits, for messages; "nan" as in to_text().
std::string to_short_text(double value);

/// Returns two numbers as texts with the fewest significant digits, at least @p n_digits, in which they
/// differ: "2.0000004" and "2". Equal numbers give equal texts.
std::pair<std::string, std::string> distinct_texts(double one, double other, int n_digits = 6);

/// Returns the finite number @p value rounded to @p n_digits significant digits: 0.3 for 0.30000000000000004.
double rounded(double value, int n_digits);

/// Returns @p text with typographic blanks, minus signs and en dashes as blanks and hyphens of a keyboard.
std::string as_typed(std::string text);

/// Parses all of @p text as a finite number (as_typed(); leading + and outer blanks allowed) or std::nullopt.
std::optional<double> parse_number(const std::string &text);

/// Returns the number at the beginning of @p text and its length [bytes]; 0: no number. Leading blanks or +
/// are not allowed.
std::pair<double, std::size_t> leading_number(const std::string &text);

/// Parses all of @p text as a non-negative integer; std::nullopt otherwise.
std::optional<unsigned int> parse_count(const std::string &text);

} // namespace stemware::pipeline
