#pragma once

#include <cmath>
#include <limits>

namespace stemware
{
/// Returns @p n times the machine epsilon times |@p quantity|, the tolerance of results that are exact up to
/// rounding.
inline double ulps(double n, double quantity)
{
  return n * std::numeric_limits<double>::epsilon() * std::abs(quantity);
}
} // namespace stemware
