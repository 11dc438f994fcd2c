#include "fem/pipeline/base/numbers.h"

#include <boost/algorithm/string/replace.hpp>
#include <boost/algorithm/string/trim.hpp>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>

namespace stemware::pipeline
{

namespace
{

std::string printed(const char *pattern, int precision, double value)
{
  std::array<char, 32> buffer;
  std::snprintf(buffer.data(), buffer.size(), pattern, precision, value);
  return buffer.data();
}

/// Returns the shortest text that is read as the same number.
std::string shortest(double value)
{
#ifdef __cpp_lib_to_chars
  std::array<char, 32> buffer;
  return { buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr };
#else // std::to_chars() of some libraries (emscripten's) supports integers only
  std::string text;
  for (int n = 1; n <= 17 && (n == 1 || std::strtod(text.c_str(), nullptr) != value); ++n)
    text = printed("%.*g", n, value);
  return text;
#endif
}

/// Simplifies exponents as in hand-written files: 7e+10 -> 7e10, 3e-04 -> 3e-4.
std::string tidy(const std::string &text)
{
  const auto exponent = text.find('e');
  if (exponent == std::string::npos)
    return text == "-nan" ? "nan" : text;
  const bool negative = text[exponent + 1] == '-';
  const auto digits = text.find_first_not_of('0', exponent + 2);
  return text.substr(0, exponent + 1) + (negative ? "-" : "") + text.substr(digits);
}

std::string trimmed(const std::string &text)
{
  const std::string digits = boost::trim_copy(text);
  return digits.size() > 1 && digits[0] == '+' && digits[1] != '-' ? digits.substr(1) : digits;
}

} // namespace

std::string to_text(double value)
{
  return tidy(shortest(value));
}

std::string to_short_text(double value)
{
  return tidy(printed("%.*g", 6, value));
}

std::pair<std::string, std::string> distinct_texts(double one, double other, int n_digits)
{
  std::pair<std::string, std::string> texts;
  for (int n = n_digits; n <= std::numeric_limits<double>::max_digits10; ++n)
  {
    texts = { tidy(printed("%.*g", n, one)), tidy(printed("%.*g", n, other)) };
    if (texts.first != texts.second || one == other)
      break;
  }
  return texts;
}

double rounded(double value, int n_digits)
{
  return std::strtod(printed("%.*e", n_digits - 1, value).c_str(), nullptr);
}

std::pair<double, std::size_t> leading_number(const std::string &text)
{
  // Refuses the hexadecimal numbers, blanks, leading + and underflows to 0 that strtod() accepts.
  const std::string decimal = text.substr(0, text.find_first_of("xX"));
  char *end = nullptr;
  errno = 0;
  const double value = std::strtod(decimal.c_str(), &end);
  const bool is_number = decimal.find_first_of("+ \t\n\v\f\r") != 0 && !(errno == ERANGE && value == 0);
  return { value, is_number ? end - decimal.c_str() : 0 };
}

std::string as_typed(std::string text)
{
  const auto is_ascii = [](char letter) { return (letter & 0x80) == 0; };
  if (std::all_of(text.begin(), text.end(), is_ascii))
    return text;
  for (const char *blank : { "\u00a0", "\u2007", "\u2009", "\u202f" })
    boost::replace_all(text, blank, " ");
  for (const char *minus : { "\u2212", "\u2013" })
    boost::replace_all(text, minus, "-");
  return text;
}

std::optional<double> parse_number(const std::string &text)
{
  const std::string digits = trimmed(as_typed(text));
  const auto [value, length] = leading_number(digits);
  return length > 0 && length == digits.size() && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::optional<unsigned int> parse_count(const std::string &text)
{
  const std::string digits = trimmed(text);
  unsigned int count = 0;
  const char *const end = digits.data() + digits.size();
  const auto [last, error] = std::from_chars(digits.data(), end, count);
  return error == std::errc() && last == end ? std::optional(count) : std::nullopt;
}

} // namespace stemware::pipeline
