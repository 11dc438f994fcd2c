#pragma once

#include "ring_model/load/ring_stack.h"
#include "ring_model/motion.h"

#include <vector>

namespace stemware::ring
{
/// Slip of a place of the rim over the table and the friction on it: x along the direction of travel, y to
/// the left.
struct RimSlip
{
  double azimuth = 0;                    ///< theta [rad]
  double slip_x = 0, slip_y = 0;         ///< velocity over the hand's speed
  double friction_x = 0, friction_y = 0; ///< per angle, over that of the mean load at rest
};

/// Slip and friction of the load, as far as it presses, at 24 places of a rim of this @p radius [m] that
/// spins with @p omega [rad/s].
std::vector<RimSlip> rim_slip(const Motion &motion, double radius, const RingStack &load, double omega);
} // namespace stemware::ring
