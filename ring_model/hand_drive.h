#pragma once

#include "ring_model/load_model.h"
#include "ring_model/moment_balance.h"
#include "ring_model/orbit_speed_table.h"
#include "ring_model/yaw_dynamics.h"

#include <memory>

namespace stemware::ring
{
/**
 * Yaw torque tau_z(t, omega) for spin_up() while the orbit speed follows a table: the quasi-static balances
 * of the moment, with the hand's tangential force m dv/dt in them (closures `hand` and `full`).
 * First-harmonic load in closed form.
 *
 * @param radius Ring radius [m]. @throws std::invalid_argument if the motion or the radius is not allowed.
 */
TimedTorqueFunction driven_torque(Closure closure, const Motion &motion, double radius,
                                  OrbitSpeedTable speeds);

/// driven_torque() under the loads of any model; the torque throws as SelfConsistentRing::at().
TimedTorqueFunction driven_torque(Closure closure, const Motion &motion,
                                  std::shared_ptr<const LoadModel> model, OrbitSpeedTable speeds);
} // namespace stemware::ring
