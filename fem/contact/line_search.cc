#include "fem/contact/line_search.h"

#include <boost/math/tools/toms748_solve.hpp>

#include <cmath>

namespace stemware::fem
{

double line_search_step(const std::function<double(double)> &slope, double start, double end, double noise,
                        bool may_go_beyond)
{
  constexpr double longest = 2;
  // Slopes below their rounding noise contain no information, so the full step is taken.
  const double tolerance = (may_go_beyond ? 0.02 : 0.5) * std::abs(start) + noise;
  if (start >= 0 || (end <= tolerance && (end >= -tolerance || !may_go_beyond)))
    return 1;
  const auto close_enough = [](double a, double b) { return b - a < 0.02 * b; };
  const auto stationary = [&](double from, double to, double slope_from, double slope_to)
  {
    boost::uintmax_t max_evaluations = 60;
    const auto bracket =
      boost::math::tools::toms748_solve(slope, from, to, slope_from, slope_to, close_enough, max_evaluations);
    return (bracket.first + bracket.second) / 2;
  };
  if (end > 0)
    return stationary(0, 1, start, end);
  const double beyond = slope(longest);
  return beyond <= 0 ? longest : stationary(1, longest, end, beyond);
}

} // namespace stemware::fem
