#include "ring_model/friction_functionals.h"

#include "ring_model/friction_kernels.h"
#include "ring_model/load/require.h"

#include <cmath>
#include <cstddef>

namespace stemware::ring
{
Wrench FrictionFunctionals::operator()(const RingStack &load) const
{
  return { torque(load), drag(load), side(load) };
}

FrictionFunctionals friction_functionals(double mu, const std::vector<double> &radii, unsigned int n_max,
                                         double omega, double speed)
{
  require(std::isfinite(mu) && mu >= 0., "the friction coefficient is ", mu,
          ", but must be finite and not negative");
  const std::vector<std::vector<double>> zeros(radii.size(), std::vector<double>(n_max + 1, 0.));
  const LoadFunctional none{ zeros, zeros };
  FrictionFunctionals friction{ none, none, none };
  for (std::size_t j = 0; j < radii.size(); ++j)
  {
    const FrictionKernels kernels(omega * radii[j], speed, n_max);
    for (unsigned int n = 0; n <= n_max; ++n)
    {
      // One of c_n, s_n is zero, the other 1 or -1.
      const double sign = n % 4 < 2 ? 1. : -1.;
      auto &torque = n % 2 == 0 ? friction.torque.a : friction.torque.b;
      auto &drag = n % 2 == 0 ? friction.drag.a : friction.drag.b;
      auto &side = n % 2 == 0 ? friction.side.b : friction.side.a;
      torque[j][n] = sign * mu * radii[j] * kernels.K(n);
      drag[j][n] = -sign * mu * kernels.U(n);
      if (n > 0)
        side[j][n] = (n % 2 == 0 ? -sign : sign) * mu * n * kernels.P(n);
    }
  }
  return friction;
}

Wrench coulomb_wrench(double mu, const RingStack &load, double omega, double speed)
{
  return friction_functionals(mu, load.radii(), load.n_harmonics(), omega, speed)(load);
}
} // namespace stemware::ring
