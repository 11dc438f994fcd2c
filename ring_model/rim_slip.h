#pragma once

#include "ring_model/load/ring_stack.h"
#include "ring_model/motion.h"

#include <vector>

namespace stemware::ring
{
/// Slip of a rim point over the table, and the friction on the point: x along the travel, y to the left.
struct RimSlip
{
  double azimuth = 0;                    ///< theta [rad]
  double slip_x = 0, slip_y = 0;         ///< velocity over the hand's speed
  double friction_x = 0, friction_y = 0; ///< friction per angle, over the friction of the mean load at rest
};

/// Returns slip and friction at 24 points of a rim of @p radius [m], spin @p omega [rad/s]. Negative loads
/// count as 0.
std::vector<RimSlip> rim_slip(const Motion &motion, double radius, const RingStack &load, double omega);
} // namespace stemware::ring
