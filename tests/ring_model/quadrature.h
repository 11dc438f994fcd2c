#pragma once

#include "ring_model/friction_functionals.h"
#include "ring_model/load/constants.h"

#include <cmath>
#include <functional>
#include <utility>
#include <vector>

namespace stemware::ring::test
{
/// Returns the load lambda'(theta) = lambda(-theta), the mirror image of @p load about the direction of
/// motion.
inline RingStack mirrored(const RingStack &load)
{
  std::vector<RingStack::Ring> reversed = load.rings();
  for (RingStack::Ring &ring : reversed)
    for (double &coefficient : ring.b)
      coefficient = -coefficient;
  return RingStack(std::move(reversed));
}

/// Returns the friction of @p load by the periodic trapezoidal rule on @p n_points angles, which converges
/// slowly near |eps| = 1. @p coefficient: mu as a function of the slip speed [m/s].
inline Wrench wrench_by_quadrature(const std::function<double(double)> &coefficient, const RingStack &load,
                                   double omega, double speed, unsigned int n_points)
{
  const double width = 2 * pi / n_points;
  Wrench sum{ 0., 0., 0. };
  for (const RingStack::Ring &ring : load.rings())
  {
    for (unsigned int i = 0; i < n_points; ++i)
    {
      // The points lie half a cell off theta = pi / 2, where the slip vanishes for the slip ratio 1.
      const double theta = pi / 2. + (i + 0.5) * width;
      double density = ring.a[0];
      for (unsigned int n = 1; n < ring.a.size(); ++n)
        density += ring.a[n] * std::cos(n * theta) + ring.b[n] * std::sin(n * theta);
      const double rim = omega * ring.radius;
      const double slip_x = speed - rim * std::sin(theta), slip_y = rim * std::cos(theta);
      const double slip = std::hypot(slip_x, slip_y);
      if (slip == 0.)
        continue;
      const double force = coefficient(slip) * density * width / slip;
      sum.force_x -= force * slip_x;
      sum.force_y -= force * slip_y;
      sum.torque -= force * ring.radius * (std::cos(theta) * slip_y - std::sin(theta) * slip_x);
    }
  }
  return sum;
}

inline Wrench wrench_by_quadrature(double mu, const RingStack &load, double omega, double speed,
                                   unsigned int n_points)
{
  return wrench_by_quadrature([mu](double) { return mu; }, load, omega, speed, n_points);
}
} // namespace stemware::ring::test
