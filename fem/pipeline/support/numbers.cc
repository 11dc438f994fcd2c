#include "fem/pipeline/support/numbers.h"

#include <boost/algorithm/string/trim.hpp>

#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace stemware::pipeline
{

namespace
{

#ifdef __cpp_lib_to_chars

namespace chars = std;
using Format = std::chars_format;

#else

/// std::to_chars and std::from_chars of a standard library that has them for whole numbers alone, as that of
/// emscripten: a browser has one locale.
namespace chars
{
enum class chars_format
{
  general,
  scientific
};
using Format = chars_format;

std::to_chars_result to_chars(char *begin, char *end, double value, Format format, int precision)
{
  const char *const pattern = format == Format::general ? "%.*g" : "%.*e";
  return { begin + std::snprintf(begin, static_cast<std::size_t>(end - begin), pattern, precision, value),
           {} };
}

/// The shortest text that reads back as the same number.
std::to_chars_result to_chars(char *begin, char *end, double value)
{
  std::to_chars_result result = to_chars(begin, end, value, Format::general, 1);
  for (int n = 2; n <= 17 && std::strtod(begin, nullptr) != value; ++n)
    result = to_chars(begin, end, value, Format::general, n);
  return result;
}

std::from_chars_result from_chars(const char *begin, const char *end, double &value)
{
  const std::string text(begin, end);
  char *last = nullptr;
  const double number = std::strtod(text.c_str(), &last);
  const std::string read = text.substr(0, static_cast<std::size_t>(last - text.c_str()));
  if (read.empty() || read.find_first_of("+ \t\nxXpP") == 0 ||
      read.find_first_of("xXpP") != std::string::npos)
    return { begin, std::errc::invalid_argument };
  value = number;
  return { begin + read.size(), {} };
}

std::from_chars_result from_chars(const char *begin, const char *end, unsigned int &value)
{
  return std::from_chars(begin, end, value);
}
} // namespace chars

using chars::Format;

#endif

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
  const auto [last, error] = chars::from_chars(digits.data(), end, value);
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
  return tidy(buffer.data(), chars::to_chars(buffer.data(), buffer.data() + buffer.size(), value));
}

std::string to_short_text(double value)
{
  std::array<char, 32> buffer;
  return tidy(buffer.data(),
              chars::to_chars(buffer.data(), buffer.data() + buffer.size(), value, Format::general, 6));
}

double rounded(double value, int n_digits)
{
  std::array<char, 32> buffer;
  const auto digits =
    chars::to_chars(buffer.data(), buffer.data() + buffer.size(), value, Format::scientific, n_digits - 1);
  chars::from_chars(buffer.data(), digits.ptr, value);
  return value;
}

std::optional<double> parse_number(const std::string &text)
{
  const auto value = parse_whole<double>(text);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

LeadingNumber leading_number(const std::string &text)
{
  LeadingNumber number;
  const auto [end, error] = chars::from_chars(text.data(), text.data() + text.size(), number.value);
  if (error == std::errc())
    number.length = static_cast<std::size_t>(end - text.data());
  return number;
}

std::optional<unsigned int> parse_count(const std::string &text)
{
  return parse_whole<unsigned int>(text);
}

} // namespace stemware::pipeline
