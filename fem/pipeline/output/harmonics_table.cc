#include "fem/pipeline/output/harmonics_table.h"

#include "fem/pipeline/support/text_layout.h"

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>

namespace stemware::pipeline
{

namespace
{

constexpr double degree = boost::math::constants::degree<double>();

/// Six digits, and 0 for what is rounding.
std::string share(double value)
{
  return formatted("%.6g", std::abs(value) < 1e-12 ? 0 : value);
}

/// Where a cos n theta + b sin n theta is largest, in degrees; without the minus of a rounded zero.
std::string crest(double a, double b, unsigned int n)
{
  const double angle = std::round(10 * std::atan2(b, a) / n / degree) / 10;
  return formatted("%.1f", angle + 0.);
}

} // namespace

ReportTable harmonics_table(const ring::RingStack &load)
{
  ReportTable table = { "Harmonics of the load over its mean, a_0 = " + formatted("%.6g", load.a(0)) +
                          " N/rad",
                        { "n", "a_n / a_0", "b_n / a_0", "amplitude / a_0", "largest at θ (degrees)" },
                        {} };
  for (unsigned int n = 1; n <= std::min(load.n_harmonics(), 8u); ++n)
  {
    const double a = load.a(n) / load.a(0), b = load.b(n) / load.a(0), amplitude = std::hypot(a, b);
    table.rows.push_back(
      { std::to_string(n), share(a), share(b), share(amplitude), amplitude > 1e-12 ? crest(a, b, n) : "–" });
  }
  return table;
}

} // namespace stemware::pipeline
