#include "ring_model/moment_balance.h"

#include "ring_model/load/require.h"

namespace stemware::ring
{
std::string to_string(Closure closure)
{
  switch (closure)
  {
  case Closure::paper:
    return "paper";
  case Closure::hand:
    return "hand";
  case Closure::full:
    return "full";
  }
  throw std::invalid_argument("the closure is none of paper, hand, full");
}

double friction_arm(Closure closure, const Motion &motion)
{
  switch (closure)
  {
  case Closure::paper:
    return 0.;
  case Closure::hand:
    return motion.force_offset + (motion.centre_of_mass_height - motion.total_centre_height());
  case Closure::full:
    return motion.centre_of_mass_height + motion.force_offset;
  }
  throw std::invalid_argument("the closure is none of paper, hand, full");
}

Eigen::Vector2d required_moment(Closure closure, const Motion &motion, const Eigen::Vector2d &friction)
{
  Eigen::Vector2d acceleration = motion.acceleration();
  if (closure == Closure::paper)
    acceleration.x() = 0.;
  // k: unit vector upwards, k x (x, y) = (-y, x). Friction acts directly and through the hand force, which is
  // mass times acceleration minus friction.
  const auto k_cross = [](const Eigen::Vector2d &vector) { return Eigen::Vector2d(-vector.y(), vector.x()); };
  const double offset = motion.force_offset + (motion.centre_of_mass_height - motion.overturning_height());
  return -offset * motion.total_mass() * k_cross(acceleration) +
         friction_arm(closure, motion) * k_cross(friction);
}

Eigen::Vector2d required_moment_at_rest(Closure closure, const Motion &motion)
{
  return required_moment(closure, motion, { -motion.friction_at_rest() * motion.normal_force(), 0. });
}
} // namespace stemware::ring
