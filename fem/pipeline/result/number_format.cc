#include "fem/pipeline/result/number_format.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace stemware::pipeline::format
{

namespace
{

int decimals_of(double spread)
{
  constexpr int of_nothing = 6;
  return spread > 0 ? std::max(0, 1 - static_cast<int>(std::floor(std::log10(spread)))) : of_nothing;
}

} // namespace

std::string number(double value, const std::string &digits)
{
  if (digits == "band")
  {
    if (!(value > 0))
      return std::isnan(value) ? missing : "0";
    const double unit = std::pow(10., std::floor(std::log10(value)) - 1); // place value of the second digit
    return number(std::ceil(value / unit * (1 - 1e-9)) * unit, ".1e");
  }
  if (!digits.empty() && digits.back() == '%')
    return number(100 * value, digits.substr(0, digits.size() - 1)) + " %";
  if (!std::isfinite(value))
    return missing;
  const bool is_nothing = value == 0 && (digits.front() == '+' || digits.back() == 'e') && digits[0] != '#';
  return is_nothing ? "0" : fmt::format(fmt::runtime("{:" + digits + "}"), value);
}

std::string rounded_to_error(double value, double spread)
{
  return number(value, "." + std::to_string(decimals_of(spread)) + "f");
}

std::string spin(double omega, const std::optional<double> &band)
{
  constexpr int n_digits = 4;
  if (omega == 0 || !std::isfinite(omega))
    return number(omega, ".4g");
  const int decimals = n_digits - 1 - static_cast<int>(std::floor(std::log10(std::abs(omega))));
  return band && *band > 0 && decimals_of(*band) < decimals ? rounded_to_error(omega, *band)
                                                            : number(omega, "#.4g");
}

std::string with_band(double value, const std::optional<double> &band)
{
  if (!band || !(*band > 0))
    return number(value, "#.6g");
  const double unit = std::pow(10, -decimals_of(*band));
  const double shift = std::abs(value - std::round(value / unit) * unit);
  return rounded_to_error(value, *band) + " ± " +
         rounded_to_error(std::ceil((*band + shift) / unit * (1 - 1e-9)) * unit, *band);
}

} // namespace stemware::pipeline::format
