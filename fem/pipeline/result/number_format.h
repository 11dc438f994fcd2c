#pragma once

#include <optional>
#include <string>

/// Number formats of console and reports. Files for programs have all digits.
namespace stemware::pipeline::format
{

/// Text of a missing number.
inline constexpr char missing[] = "–";

/// Returns @p value formatted by fmt with @p digits, ".6g"; `missing` if it is not finite. Further formats:
///
///   .1f%      per cent: "25.0 %"
///   +.3g      a sign, but "0" for zero
///   .2e       a power of ten, but "0" for zero; #.2e also for zero
///   band      half-width of an error band, rounded up to two digits: "4.9e-06"
std::string number(double value, const std::string &digits);

/// Returns @p value rounded to two digits of @p spread, its error: "-3.6489" for a spread of 0.0002.
std::string rounded_to_error(double value, double spread);

/// Returns a spin [rad/s] for texts: the digits that @p band allows, at most four significant ones.
std::string spin(double omega, const std::optional<double> &band = {});

/// Returns @p value with its @p band, rounded up so that the printed interval contains value -/+ band; six
/// digits without a band.
std::string with_band(double value, const std::optional<double> &band);

} // namespace stemware::pipeline::format
