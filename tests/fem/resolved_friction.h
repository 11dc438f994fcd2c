#pragma once

#include "fem/contact/contact_surface.h"
#include "fem/contact/sliding_traction.h"

#include <vector>

namespace stemware::fem_tests
{

/// Resultants of Coulomb friction of point forces in the plane, without projection onto rings.
struct ResolvedFriction
{
  double torque = 0;  ///< about the ring's centre, counter-clockwise > 0 [N m]
  double force_x = 0; ///< along the direction of travel [N]
  double force_y = 0; ///< to the left of it [N]
};

/// Returns the friction of point forces on a foot with velocity @p speed along x and spin @p omega: sum of
/// -mu f v_rel / |v_rel|, v_rel = (v - omega y, omega x). Points without slip have no friction.
inline ResolvedFriction resolved_friction(const std::vector<fem::PointForce> &forces,
                                          double friction_coefficient, double omega, double speed)
{
  ResolvedFriction friction;
  for (const fem::PointForce &point : forces)
  {
    const Eigen::Vector2d force =
      fem::coulomb_friction({ speed - omega * point.y, omega * point.x }, friction_coefficient * point.force);
    friction.force_x += force(0);
    friction.force_y += force(1);
    friction.torque += point.x * force(1) - point.y * force(0);
  }
  return friction;
}

} // namespace stemware::fem_tests
