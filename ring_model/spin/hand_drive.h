#pragma once

#include "ring_model/moment_balance.h"
#include "ring_model/orbit_speed_table.h"
#include "ring_model/spin/sample.h"
#include "ring_model/yaw_motion.h"

#include <functional>
#include <vector>

namespace stemware::ring
{
/// Returns the yaw torque for yaw_motion() under an orbit speed table: quasi-static moment balances including
/// the hand's tangential force m dv/dt (moment balances `hand` and `full`). First-harmonic load.
///
/// @p radius: ring radius [m]. Throws std::invalid_argument if the motion or the radius is not allowed.
PhasedTorqueFunction driven_torque(Closure closure, const Motion &motion, double radius,
                                   OrbitSpeedTable speeds);

/// Load of a glass whose orbit is @p now at the time @p time [s], at the spin @p omega [rad/s].
using DrivenLoad = std::function<Sample(const Motion &now, double time, double omega)>;

/// Returns the yaw torque of friction and lean for driven_motion() under @p load.
PhasedTorqueFunction driven_torque(const Motion &motion, OrbitSpeedTable speeds, DrivenLoad load);

/// Integrates yaw_motion() from rest while the hand follows @p speeds, also from rest, and the fingers resist
/// with up to @p grip [N m] in addition to @p torque: the spin stays 0 until v is (accuracy / 10)^(1/3) of
/// the largest speed. Until then a free spin would be smaller than @p accuracy, because a spin that follows
/// its torque grows with v^3 (docs/theory/dynamics.md). @p motion: its inertia, and v / R with @p radius [m]
/// as the scale of spins.
std::vector<YawSample> driven_motion(const PhasedTorqueFunction &torque, const OrbitSpeedTable &speeds,
                                     const Motion &motion, double grip, double radius,
                                     const std::vector<double> &times, double accuracy);

/// Returns the absolute change of driven_motion()'s spin at each of @p times if the entries of @p speeds are
/// interpolated linearly instead of by the monotone cubic, with a first harmonic on a rigid ring of @p radius
/// [m] in balance [rad/s].
std::vector<double> interpolation_changes(Closure closure, const Motion &motion, double grip, double radius,
                                          const OrbitSpeedTable &speeds, const std::vector<double> &times);

/// Instant at which a glass at rest begins to slide under a growing force of the hand.
struct Breakaway
{
  double time;   ///< time at which the hand starts [s]
  Motion motion; ///< motion at that time, with the static friction coefficient and without an acceleration
  double force;  ///< force of the hand at breakaway, along the motion to come [N]
  double moment_ratio; ///< |M_N| / (N R / 2); from 2 on the glass tips first
};

/// Returns the breakaway of a rigid ring of @p radius [m] whose hand starts from rest. @p static_friction:
/// its coefficient; 0: coefficient of the law at rest.
Breakaway find_breakaway(Closure closure, const Motion &motion, double static_friction, double radius,
                         const OrbitSpeedTable &speeds);
} // namespace stemware::ring
