#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>

namespace stemware::pipeline
{

/// Shortest decimal text that reads back as the same double: 0.03, 7e10, 3e-4; "nan" for every one that is
/// not a number.
std::string to_text(double value);

/// Returns at most six significant digits, for messages and files of pictures; "nan" as in to_text().
std::string to_short_text(double value);

/// Two numbers for a sentence that compares them, with as few significant digits, from @p n_digits on, as
/// tell them apart: "2.0000004" and "2". Equal numbers are printed alike.
std::pair<std::string, std::string> distinct_texts(double one, double other, int n_digits = 6);

/// The finite number @p value to @p n_digits significant digits: 0.3 for the 0.30000000000000004 of a sum.
double rounded(double value, int n_digits);

/// Returns @p text with the blanks and minus signs of the keyboard in place of those that pages and
/// spreadsheets print: no-break, figure, thin and narrow no-break space, minus sign and en dash.
std::string as_typed(std::string text);

/// Returns the finite number that makes up the whole of @p text (as_typed(); a leading + and surrounding
/// blanks are allowed), or std::nullopt.
std::optional<double> parse_number(const std::string &text);

/// A number and how many characters of a text it takes.
struct LeadingNumber
{
  double value = 0;
  std::size_t length = 0; ///< 0: there is none
};

/// The number that @p text begins with, without blanks and a leading +.
LeadingNumber leading_number(const std::string &text);

/// The non-negative whole number that makes up the whole of @p text, or nothing.
std::optional<unsigned int> parse_count(const std::string &text);

} // namespace stemware::pipeline
