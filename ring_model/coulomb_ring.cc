#include "ring_model/coulomb_ring.h"

#include "ring_model/constants.h"
#include "ring_model/friction_kernels.h"
#include "ring_model/require.h"

#include <cmath>

namespace stemware::ring
{
namespace
{
/// Harmonic n of lambda seen from psi = theta - 90 deg, where the slip velocity is symmetric.
struct SlipHarmonic
{
  double even; ///< coefficient of cos(n psi): a_n cos(n pi/2) + b_n sin(n pi/2)
  double odd;  ///< coefficient of sin(n psi): b_n cos(n pi/2) - a_n sin(n pi/2)
};

SlipHarmonic slip_harmonic(const RingStack::Ring &load, unsigned int n)
{
  switch (n % 4)
  {
  case 0:
    return { load.a[n], load.b[n] };
  case 1:
    return { load.b[n], -load.a[n] };
  case 2:
    return { -load.a[n], -load.b[n] };
  default:
    return { -load.b[n], load.a[n] };
  }
}
} // namespace

CoulombRing::CoulombRing(double friction_coefficient)
    : mu(friction_coefficient)
{
  require(std::isfinite(mu) && mu >= 0., "the friction coefficient is ", mu,
          ", but must be finite and not negative");
}

Wrench CoulombRing::wrench(const RingStack &load, double omega, double speed) const
{
  Wrench total{ 0., 0., 0. };
  for (const RingStack::Ring &ring : load.rings())
  {
    const FrictionKernels kernels(omega * ring.radius, speed, load.n_harmonics());
    Wrench sum{ ring.a[0] * kernels.K(0), ring.a[0] * kernels.U(0), 0. };
    for (unsigned int n = 1; n <= load.n_harmonics(); ++n)
    {
      const SlipHarmonic harmonic = slip_harmonic(ring, n);
      sum.torque += harmonic.even * kernels.K(n);
      sum.force_x += harmonic.even * kernels.U(n);
      sum.force_y += n * harmonic.odd * kernels.P(n);
    }
    total.torque += mu * ring.radius * sum.torque;
    total.force_x -= mu * sum.force_x;
    total.force_y -= mu * sum.force_y;
  }
  return total;
}

Wrench CoulombRing::wrench_by_quadrature(const RingStack &load, double omega, double speed,
                                         unsigned int n_points) const
{
  require(n_points > 0, "the quadrature has no points; give at least one");
  require(std::isfinite(omega) && std::isfinite(speed) && speed >= 0., "the ring slides with ", speed,
          " m/s and spins with ", omega, " rad/s, but both must be finite and the speed not negative");
  const double width = 2 * pi / n_points;
  Wrench sum{ 0., 0., 0. };
  for (const RingStack::Ring &ring : load.rings())
  {
    for (unsigned int i = 0; i < n_points; ++i)
    {
      // Half a cell off psi = 0, where the slip vanishes at eps = 1.
      const double theta = pi / 2. + (i + 0.5) * width;
      double density = ring.a[0];
      for (unsigned int n = 1; n < ring.a.size(); ++n)
        density += ring.a[n] * std::cos(n * theta) + ring.b[n] * std::sin(n * theta);
      const double rim = omega * ring.radius;
      const double slip_x = speed - rim * std::sin(theta), slip_y = rim * std::cos(theta);
      const double slip = std::hypot(slip_x, slip_y);
      if (slip == 0.)
        continue;
      const double force = mu * density * width / slip;
      sum.force_x -= force * slip_x;
      sum.force_y -= force * slip_y;
      sum.torque -= force * ring.radius * (std::cos(theta) * slip_y - std::sin(theta) * slip_x);
    }
  }
  return sum;
}

double CoulombRing::dissipation(const RingStack &load, double omega, double speed) const
{
  double power = 0.;
  for (const RingStack::Ring &ring : load.rings())
  {
    const FrictionKernels kernels(omega * ring.radius, speed, load.n_harmonics());
    double sum = ring.a[0] * kernels.slip_speed(0);
    for (unsigned int n = 1; n <= load.n_harmonics(); ++n)
      sum += slip_harmonic(ring, n).even * kernels.slip_speed(n);
    power += mu * sum;
  }
  return power;
}

double CoulombRing::truncation_bound(const RingStack &load, unsigned int n_max, double omega,
                                     double speed) const
{
  double bound = 0.;
  for (const RingStack::Ring &ring : load.rings())
  {
    const FrictionKernels kernels(omega * ring.radius, speed, load.n_harmonics());
    double sum = 0.;
    for (unsigned int n = n_max + 1; n <= load.n_harmonics(); ++n)
      sum += std::hypot(ring.a[n], ring.b[n]) * std::abs(kernels.K(n));
    bound += mu * ring.radius * sum;
  }
  return bound;
}
} // namespace stemware::ring
