#pragma once

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <string>

/// How people read a number: the digits of a quantity on the console and in reports. Files for programs have
/// all digits.
namespace stemware::pipeline::format
{

/// Up to @p digits significant digits, without zeros at the end: "-3.129".
template <int digits>
std::string significant(double value)
{
  return fmt::format(FMT_STRING("{:.{}g}"), value, digits);
}

/// @p digits significant digits, with zeros at the end: "-3.12900".
template <int digits>
std::string all_significant(double value)
{
  return fmt::format(FMT_STRING("{:#.{}g}"), value, digits);
}

/// Up to @p digits significant digits with the sign: "+0.0295"; "0" for nothing.
template <int digits>
std::string signed_significant(double value)
{
  return value == 0 ? "0" : fmt::format(FMT_STRING("{:+.{}g}"), value, digits);
}

/// A count that is an estimate, to two significant digits: "about 4400".
inline std::string about(double value)
{
  const double unit = value > 0 ? std::pow(10., std::floor(std::log10(value)) - 1) : 1;
  return fmt::format(FMT_STRING("about {:.0f}"), std::round(value / unit) * unit);
}

/// "-3.129e+00".
template <int digits>
std::string scientific(double value)
{
  return fmt::format(FMT_STRING("{:.{}e}"), value, digits);
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
  return fmt::format(FMT_STRING("{:.{}f}"), value, digits);
}

/// A share in per cent to @p digits significant digits: "25 %".
template <int digits>
std::string percent(double share)
{
  return fmt::format(FMT_STRING("{:.{}g} %"), 100 * share, digits);
}

/// A share in per cent with @p digits decimals: "79.3 %".
template <int digits>
std::string percent_fixed(double share)
{
  return fmt::format(FMT_STRING("{:.{}f} %"), 100 * share, digits);
}

/// A change in per cent with its sign, to three significant digits: "+0.274 %"; "0 %" for none.
inline std::string change(double share)
{
  return share == 0 ? "0 %" : fmt::format(FMT_STRING("{:+.3g} %"), 100 * share);
}

/// A change in per cent with its sign and three decimals: "+17.900 %".
inline std::string change_fixed(double share)
{
  return fmt::format(FMT_STRING("{:+.3f} %"), 100 * share);
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
  return fmt::format(FMT_STRING("{:.{}f}"), value, decimals_of(spread));
}

/// The half-width of an error band by itself, rounded up to two digits: "4.9e-06".
inline std::string band(double value)
{
  if (!(value > 0))
    return "0";
  const double unit = std::pow(10., std::floor(std::log10(value)) - 1);
  return scientific<1>(std::ceil(value / unit * (1 - 1e-9)) * unit);
}

} // namespace stemware::pipeline::format
