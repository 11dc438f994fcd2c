#include "ring_model/coulomb_ring.h"

#include "ring_model/constants.h"
#include "ring_model/friction_kernels.h"
#include "ring_model/load_functional.h"
#include "ring_model/require.h"

#include <cmath>
#include <vector>

namespace stemware::ring
{
namespace
{
/// a_n cos(n pi/2) + b_n sin(n pi/2): harmonic n of lambda as far as it is even in theta - 90 deg, like the
/// slip speed.
double even_part(const RingStack::Ring &load, unsigned int n)
{
  return (n % 4 < 2 ? 1. : -1.) * (n % 2 == 0 ? load.a[n] : load.b[n]);
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
  std::vector<double> radii;
  for (const RingStack::Ring &ring : load.rings())
    radii.push_back(ring.radius);
  const FrictionFunctionals friction = friction_functionals(mu, radii, load.n_harmonics(), omega, speed);
  return { friction.torque(load), friction.drag(load), friction.side(load) };
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
    double sum = 0.;
    for (unsigned int n = 0; n <= load.n_harmonics(); ++n)
      sum += even_part(ring, n) * kernels.slip_speed(n);
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
