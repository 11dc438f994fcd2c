#pragma once

#include "ring_model/load/lagrange.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace stemware::ring
{
/// Driving torque at a spin; both are positive in the direction of the torque at rest.
struct DrivingTorque
{
  double spin;   ///< > 0 [rad/s]
  double torque; ///< tau_z - tau_g [N m], positive before the zero
};

/// Returns whether the torque of @p one is closer to zero.
inline bool has_smaller_torque(const DrivingTorque &one, const DrivingTorque &other)
{
  return std::abs(one.torque) < std::abs(other.torque);
}

/// Estimate of the spin at which the torque vanishes.
struct Estimate
{
  double spin;  ///< estimate by the polynomial spin(torque) through at most four samples
  double error; ///< difference to the estimate without the farthest sample
};

/// Returns the estimate from the one to four @p samples (not empty) of smallest |torque| between which the
/// torque decreases with the spin; more would add rounding only. The error from one sample is HUGE_VAL.
inline Estimate inverse_interpolation(std::vector<DrivingTorque> samples)
{
  std::sort(samples.begin(), samples.end(), has_smaller_torque);
  const auto falls = [&](std::size_t n)
  {
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (!((samples[i].torque - samples[j].torque) * (samples[i].spin - samples[j].spin) < 0.))
          return false;
    return true;
  };
  std::size_t n = std::min<std::size_t>(samples.size(), 4); // a cubic
  while (!falls(n))
    --n;
  const auto through = [&](std::size_t n_used)
  {
    Eigen::VectorXd torques(n_used), distances(n_used); // relative to the spin of the smallest torque
    for (std::size_t i = 0; i < n_used; ++i)
    {
      torques(i) = samples[i].torque;
      distances(i) = samples[i].spin - samples.front().spin;
    }
    return samples.front().spin + lagrange_values(torques, 0.).dot(distances);
  };
  return n < 2 ? Estimate{ through(1), HUGE_VAL }
               : Estimate{ through(n), std::abs(through(n) - through(n - 1)) };
}
} // namespace stemware::ring
