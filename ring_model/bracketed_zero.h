#pragma once

#include "ring_model/failures.h"
#include "ring_model/load/require.h"

#include <boost/math/tools/toms748_solve.hpp>

#include <cmath>
#include <cstdint>

namespace stemware::ring
{
/// Returns the zero of @p function between @p one and @p other, to rounding. The values @p at_one and @p
/// at_other have opposite signs, or one is 0. Throws NoBalance naming @p what after 200 steps.
template <typename Function>
double bracketed_zero(const Function &function, double one, double other, double at_one, double at_other,
                      const char *what)
{
  if (one > other)
    return bracketed_zero(function, other, one, at_other, at_one, what);
  if (at_one == 0. || at_other == 0.)
    return at_one == 0. ? one : other;
  constexpr std::uintmax_t max_steps = 200;
  std::uintmax_t n_steps = max_steps;
  const auto [below, above] = boost::math::tools::toms748_solve(
    function, one, other, at_one, at_other, boost::math::tools::eps_tolerance<double>(52), n_steps);
  if (n_steps >= max_steps)
    throw NoBalance(sentence(what, " between ", one, " and ", other, " did not converge in ", max_steps,
                             " bracketing steps"));
  return std::abs(function(below)) <= std::abs(function(above)) ? below : above;
}
} // namespace stemware::ring
