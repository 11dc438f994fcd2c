#pragma once

#include <sstream>
#include <string>

namespace stemware::ring
{
/// Returns @p value as text with @p n_digits significant digits.
inline std::string rounded_text(double value, int n_digits)
{
  std::ostringstream text;
  text.precision(n_digits);
  text << value + 0.; // no -0
  return text.str();
}
} // namespace stemware::ring
