#pragma once

#include "ring_model/moment_balance.h"
#include "ring_model/orbit_speed_table.h"
#include "ring_model/yaw_motion.h"

namespace stemware::ring
{
/**
 * Yaw torque for yaw_motion() while the orbit speed follows a table: the quasi-static balances of the moment,
 * with the hand's tangential force m dv/dt in them (closures `hand` and `full`). First-harmonic load in
 * closed form.
 *
 * @param radius Ring radius [m]. @throws std::invalid_argument if the motion or the radius is not allowed.
 */
PhasedTorqueFunction driven_torque(Closure closure, const Motion &motion, double radius,
                                   OrbitSpeedTable speeds);
} // namespace stemware::ring
