#pragma once

#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <string>

/// Number formats of the console and the reports: the digits of a quantity, and the text of a missing one.
/// Files for programs have all digits.
namespace stemware::pipeline::format
{

/// Text of a missing number.
inline constexpr char missing[] = "–";

/// @p value as fmt writes it with @p digits, ".6g", missing where it is not finite, and more:
///
///   1e3*.4g   a factor in front
///   .1f%      per cent: "25.0 %"
///   +.3g      a sign, but "0" for nothing
///   .2e       a power of ten, but "0" for nothing; #.2e also for that
///   band      the half-width of an error band by itself, rounded up to two digits: "4.9e-06"
///   about     a count that is an estimate, to two digits: "about 4400"
///   short     three digits, and no power of ten for large ones: "0.27", "2110"
std::string number(double value, const std::string &digits);

/// Decimals that show two digits of @p spread.
int decimals_of(double spread);

/// @p value to two digits of @p spread, its error or its scatter: "-3.6489" where that is 0.0002.
std::string rounded_to_error(double value, double spread);

/// @p value and the band round it likewise, rounded up so that what is printed contains all of it; with six
/// digits where no band is known.
std::string with_band(double value, const std::optional<double> &band);

} // namespace stemware::pipeline::format
