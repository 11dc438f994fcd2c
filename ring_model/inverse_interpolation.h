#pragma once

#include "ring_model/load/lagrange.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace stemware::ring
{
/// Push on the glass at a spin, both counted in the direction in which the glass is driven at rest.
struct Push
{
  double spin; ///< > 0 [rad/s]
  double push; ///< tau_z - tau_g [N m], positive before the zero
};

/// Returns whether the push of @p one is closer to zero.
inline bool has_less_push(const Push &one, const Push &other)
{
  return std::abs(one.push) < std::abs(other.push);
}

/// Estimate of the spin at which the push vanishes.
struct Estimate
{
  double spin;  ///< by the polynomial spin(push) through at most four samples
  double error; ///< difference to the estimate without the farthest sample
};

/// Returns the estimate from at most four of @p samples, those with the least |push| for which the push
/// decreases with the spin; a single sample has the error HUGE_VAL. More samples would add rounding, not
/// accuracy. Precondition: @p samples is not empty.
inline Estimate inverse_interpolation(std::vector<Push> samples)
{
  std::sort(samples.begin(), samples.end(), has_less_push);
  const auto falls = [&](std::size_t n)
  {
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (!((samples[i].push - samples[j].push) * (samples[i].spin - samples[j].spin) < 0.))
          return false;
    return true;
  };
  std::size_t n = std::min<std::size_t>(samples.size(), 4); // a cubic
  while (!falls(n))
    --n;
  const auto through = [&](std::size_t n_used)
  {
    Eigen::VectorXd pushes(n_used), ways(n_used); // relative to the spin of the least push
    for (std::size_t i = 0; i < n_used; ++i)
    {
      pushes(i) = samples[i].push;
      ways(i) = samples[i].spin - samples.front().spin;
    }
    return samples.front().spin + lagrange_values(pushes, 0.).dot(ways);
  };
  return n < 2 ? Estimate{ through(1), HUGE_VAL }
               : Estimate{ through(n), std::abs(through(n) - through(n - 1)) };
}
} // namespace stemware::ring
