#include "ring_model/friction_functionals.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace stemware::ring
{
Wrench FrictionFunctionals::operator()(const RingStack &load) const
{
  return { torque(load), drag(load), side(load) };
}

FrictionFunctionals friction_functionals(const FrictionLaw &law, const std::vector<double> &radii,
                                         unsigned int n_max, double omega, double speed)
{
  const Eigen::ArrayXXd zeros = Eigen::ArrayXXd::Zero(n_max + 1, static_cast<Eigen::Index>(radii.size()));
  const LoadFunctional none{ zeros, zeros };
  FrictionFunctionals friction{ none, none, none };
  for (std::size_t j = 0; j < radii.size(); ++j)
  {
    const Eigen::ArrayX3d kernels = friction_kernels(law, omega * radii[j], speed, n_max);
    const auto column = static_cast<Eigen::Index>(j);
    for (unsigned int n = 0; n <= n_max; ++n)
    {
      // One of cos(n pi/2) and sin(n pi/2) is zero; the other equals `sign`.
      const double sign = n % 4 < 2 ? 1. : -1.;
      const bool is_even = n % 2 == 0;
      (is_even ? friction.torque.a : friction.torque.b)(n, column) = sign * radii[j] * kernels(n, 0);
      (is_even ? friction.drag.a : friction.drag.b)(n, column) = -sign * kernels(n, 1);
      (is_even ? friction.side.b : friction.side.a)(n, column) = (is_even ? sign : -sign) * kernels(n, 2);
    }
  }
  return friction;
}

FrictionFunctionals friction_functionals(const Motion &motion, const std::vector<double> &radii,
                                         unsigned int n_max, double omega)
{
  return friction_functionals(friction_law_of(motion), radii, n_max, omega, motion.orbit_speed);
}

Wrench wrench(const Motion &motion, const RingStack &load, double omega)
{
  return friction_functionals(motion, load.radii(), load.n_harmonics(), omega)(load);
}

Wrench wrench(const FrictionLaw &law, const RingStack &load, const Eigen::Vector2d &velocity, double omega)
{
  const double angle = std::atan2(velocity.y(), velocity.x());
  const auto friction = friction_functionals(law, load.radii(), load.n_harmonics(), omega,
                                             std::hypot(velocity.x(), velocity.y()));
  const Wrench one = friction(load.rotated(-angle));
  const Eigen::Vector2d force = Eigen::Rotation2Dd(angle) * Eigen::Vector2d(one.force_x, one.force_y);
  return { one.torque, force.x(), force.y() };
}

Wrench coulomb_wrench(double mu, const RingStack &load, double omega, double speed)
{
  return friction_functionals(coulomb_law(mu), load.radii(), load.n_harmonics(), omega, speed)(load);
}

TorqueByHarmonics::TorqueByHarmonics(const Motion &motion, const RingStack &load, double omega)
    : shares(load.n_harmonics() + 1)
    , bounds(load.n_harmonics() + 1)
{
  const LoadFunctional torque = friction_functionals(motion, load.radii(), load.n_harmonics(), omega).torque;
  for (unsigned int n = 0; n <= load.n_harmonics(); ++n)
    for (std::size_t j = 0; j < load.rings().size(); ++j)
    {
      const RingStack::Ring &ring = load.rings()[j];
      const double a = torque.a(n, static_cast<Eigen::Index>(j)),
                   b = torque.b(n, static_cast<Eigen::Index>(j));
      shares[n] += a * ring.a[n] + b * ring.b[n];
      bounds[n] += std::hypot(a, b) * std::hypot(ring.a[n], ring.b[n]);
    }
}

double TorqueByHarmonics::change(unsigned int n) const
{
  double sum = 0.;
  for (std::size_t k = 2; k < shares.size() && k <= n; ++k)
    sum += shares[k];
  return sum;
}

double TorqueByHarmonics::rest(unsigned int n) const
{
  return std::accumulate(shares.begin() + std::min<std::ptrdiff_t>(n + 1, shares.size()), shares.end(), 0.);
}

double TorqueByHarmonics::bound(unsigned int n) const
{
  return std::accumulate(bounds.begin() + std::min<std::ptrdiff_t>(n + 1, bounds.size()), bounds.end(), 0.);
}
} // namespace stemware::ring
