#pragma once

#include "ring_model/moment_balance.h"
#include "ring_model/orbit_speed_table.h"
#include "ring_model/yaw_motion.h"

namespace stemware::ring
{
/**
 * Returns the yaw torque for yaw_motion() under an orbit speed table: quasi-static moment balances including
 * the hand's tangential force m dv/dt (closures `hand` and `full`). First-harmonic load, in closed form for a
 * constant friction coefficient.
 *
 * @param radius Ring radius [m]. @throws std::invalid_argument if the motion or the radius is not allowed.
 */
PhasedTorqueFunction driven_torque(Closure closure, const Motion &motion, double radius,
                                   OrbitSpeedTable speeds);

/**
 * yaw_motion() from rest while the hand follows @p speeds, also from rest: the spin stays 0 until v is
 * (accuracy / 10)^(1/3) of the largest speed. Until then it is smaller than @p accuracy, because a spin that
 * follows its torque grows with v^3 (docs/theory/dynamics.md).
 */
std::vector<YawSample> driven_motion(const PhasedTorqueFunction &torque, const OrbitSpeedTable &speeds,
                                     double yaw_inertia, const std::vector<double> &times, double accuracy,
                                     double spin_scale);
} // namespace stemware::ring
