#include "ring_model/coulomb_ring.h"

#include "ring_model/friction_functionals.h"
#include "ring_model/friction_kernels.h"
#include "ring_model/load/constants.h"
#include "ring_model/load/require.h"

#include <cmath>

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
  const FrictionFunctionals friction =
    friction_functionals(mu, load.radii(), load.n_harmonics(), omega, speed);
  return { friction.torque(load), friction.drag(load), friction.side(load) };
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
