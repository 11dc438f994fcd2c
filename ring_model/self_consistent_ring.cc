#include "ring_model/self_consistent_ring.h"

#include "ring_model/failures.h"
#include "ring_model/load/require.h"

#include <Eigen/LU>

#include <utility>

namespace stemware::ring
{
SelfConsistentRing::SelfConsistentRing(Closure closure, const Motion &motion, double radius)
    : closure(closure)
    , motion(motion)
    , radius(radius)
{
  motion.validate();
  require_positive(radius, "the ring radius", "m");
}

RingEquilibrium SelfConsistentRing::at(double omega) const
{
  const double force = motion.normal_force(), scale = force * radius;
  const FrictionFunctionals friction_of = friction_functionals(motion, { radius }, 1, omega);
  const auto load_of = [&](const Eigen::Vector2d &moment)
  { return RingStack::first_harmonic(force, moment, radius); };
  const auto residual = [&](const Eigen::Vector2d &moment) -> Eigen::Vector2d
  {
    const Wrench friction = friction_of(load_of(moment));
    return required_moment(closure, motion, { friction.force_x, friction.force_y }) - moment;
  };
  // Friction is linear in the load for any friction law, so the residual is an affine function of the moment.
  Eigen::Vector2d moment = required_moment_at_rest(closure, motion), change = residual(moment);
  Eigen::Matrix2d jacobian;
  for (int i = 0; i < 2; ++i)
    jacobian.col(i) = (residual(moment + scale * Eigen::Vector2d::Unit(i)) - change) / scale;
  const Eigen::Matrix2d inverse = jacobian.inverse();
  for (int pass = 0; pass < 2; ++pass) // the second pass removes rounding errors
  {
    moment -= inverse * change;
    change = residual(moment);
  }
  if (!(change.norm() <= 1e-12 * (scale + moment.norm())))
    throw NoBalance(sentence("no equilibrium at omega = ", omega, " rad/s: the moments differ by ",
                             change.norm() / scale, " N R"));
  RingStack load = load_of(moment);
  const Wrench friction = friction_of(load);
  return { std::move(load), friction, moment.norm() / (0.5 * scale) };
}
} // namespace stemware::ring
