#include "fem/pipeline/support/numbers.h"

#include <boost/algorithm/string/trim.hpp>

#include <array>
#include <charconv>
#include <cmath>

namespace stemware::pipeline
{

namespace
{
/// Number that makes up the whole of a text. std::from_chars, unlike streams, ignores the locale and leaves
/// nothing behind unread.
template <typename Number>
std::optional<Number> parse_whole(const std::string &text)
{
  std::string digits = boost::trim_copy(text);
  if (digits.size() > 1 && digits[0] == '+' && digits[1] != '-')
    digits.erase(0, 1);
  Number value{};
  const char *end = digits.data() + digits.size();
  const auto [last, error] = std::from_chars(digits.data(), end, value);
  if (error != std::errc() || last != end)
    return std::nullopt;
  return value;
}

/// 7e+10 -> 7e10, 3e-04 -> 3e-4: the way people write study files.
std::string tidy(const char *begin, const std::to_chars_result &result)
{
  std::string text(begin, static_cast<const char *>(result.ptr));
  const auto exponent = text.find('e');
  if (exponent == std::string::npos)
    return text == "-nan" ? "nan" : text;
  const bool negative = text[exponent + 1] == '-';
  const auto digits = text.find_first_not_of('0', exponent + 2);
  return text.substr(0, exponent + 1) + (negative ? "-" : "") + text.substr(digits);
}
} // namespace

std::string to_text(double value)
{
  std::array<char, 32> buffer;
  return tidy(buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), value));
}

std::string to_short_text(double value)
{
  std::array<char, 32> buffer;
  return tidy(buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                           std::chars_format::general, 6));
}

double rounded(double value, int n_digits)
{
  std::array<char, 32> buffer;
  const auto digits = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                    std::chars_format::scientific, n_digits - 1);
  std::from_chars(buffer.data(), digits.ptr, value);
  return value;
}

std::optional<double> parse_number(const std::string &text)
{
  const auto value = parse_whole<double>(text);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<unsigned int> parse_count(const std::string &text)
{
  return parse_whole<unsigned int>(text);
}

} // namespace stemware::pipeline
