#pragma once

#include "ring_model/failures.h"
#include "ring_model/load/require.h"

#include <boost/math/tools/toms748_solve.hpp>

#include <cmath>
#include <cstdint>

namespace stemware::ring
{
/// Returns the zero of @p function between two arguments, in either order, at which it has the values @p
/// at_one and @p at_other of opposite sign or 0; to rounding. Throws NoBalance that names @p what if 200
/// steps do not suffice.
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
