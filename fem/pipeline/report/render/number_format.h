#pragma once

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <string>

/// How people read a number: the digits of a quantity on the console and in reports, missing where there is
/// none. Files for programs have all digits.
namespace stemware::pipeline::format
{

/// Text in the place of a number that does not exist.
inline constexpr char missing[] = "–";

/// A number of a sentence or table, under the formats of fmt: "{:.3g}" writes missing where it is not finite.
struct Number
{
  double value;
};

} // namespace stemware::pipeline::format

template <>
struct fmt::formatter<stemware::pipeline::format::Number> : fmt::formatter<double>
{
  template <typename Context>
  auto format(const stemware::pipeline::format::Number &number, Context &context) const
  {
    if (std::isfinite(number.value))
      return fmt::formatter<double>::format(number.value, context);
    return fmt::format_to(context.out(), "{}", stemware::pipeline::format::missing);
  }
};

namespace stemware::pipeline::format
{

/// Up to @p digits significant digits, without zeros at the end: "-3.129".
template <int digits>
std::string significant(double value)
{
  return fmt::format(FMT_STRING("{:.{}g}"), Number{ value }, digits);
}

/// @p digits significant digits, with zeros at the end: "-3.12900".
template <int digits>
std::string all_significant(double value)
{
  return fmt::format(FMT_STRING("{:#.{}g}"), Number{ value }, digits);
}

/// Up to @p digits significant digits with the sign: "+0.0295"; "0" for nothing.
template <int digits>
std::string signed_significant(double value)
{
  return value == 0 ? "0" : fmt::format(FMT_STRING("{:+.{}g}"), Number{ value }, digits);
}

/// A count that is an estimate, to two significant digits: "about 4400".
inline std::string about(double value)
{
  const double unit = value > 0 ? std::pow(10., std::floor(std::log10(value)) - 1) : 1;
  return fmt::format(FMT_STRING("about {:.0f}"), Number{ std::round(value / unit) * unit });
}

/// "-3.129e+00".
template <int digits>
std::string scientific(double value)
{
  return fmt::format(FMT_STRING("{:.{}e}"), Number{ value }, digits);
}

/// "-3.129e+00", and "0" for nothing.
template <int digits>
std::string scientific_or_zero(double value)
{
  return value == 0 ? "0" : scientific<digits>(value);
}

/// "-3.129".
template <int digits>
std::string fixed(double value)
{
  return fmt::format(FMT_STRING("{:.{}f}"), Number{ value }, digits);
}

/// A share in per cent to @p digits significant digits: "25 %".
template <int digits>
std::string percent(double share)
{
  return fmt::format(FMT_STRING("{:.{}g} %"), Number{ 100 * share }, digits);
}

/// A share in per cent with @p digits decimals: "79.3 %".
template <int digits>
std::string percent_fixed(double share)
{
  return fmt::format(FMT_STRING("{:.{}f} %"), Number{ 100 * share }, digits);
}

/// A change in per cent with its sign, to three significant digits: "+0.274 %"; "0 %" for none.
inline std::string change(double share)
{
  return share == 0 ? "0 %" : fmt::format(FMT_STRING("{:+.3g} %"), Number{ 100 * share });
}

/// A change in per cent with its sign and three decimals: "+17.900 %".
inline std::string change_fixed(double share)
{
  return fmt::format(FMT_STRING("{:+.3f} %"), Number{ 100 * share });
}

/// Decimals that show two digits of @p spread.
inline int decimals_of(double spread)
{
  constexpr int of_nothing = 6;
  return spread > 0 ? std::max(0, 1 - static_cast<int>(std::floor(std::log10(spread)))) : of_nothing;
}

/// @p value to two digits of @p spread, its error or its scatter: "-3.6489" where that is 0.0002.
inline std::string to_spread(double value, double spread)
{
  return fmt::format(FMT_STRING("{:.{}f}"), Number{ value }, decimals_of(spread));
}

/// The half-width of an error band by itself, rounded up to two digits: "4.9e-06".
inline std::string band(double value)
{
  if (std::isnan(value))
    return missing;
  if (!(value > 0))
    return "0";
  const double unit = std::pow(10., std::floor(std::log10(value)) - 1);
  return scientific<1>(std::ceil(value / unit * (1 - 1e-9)) * unit);
}

} // namespace stemware::pipeline::format
