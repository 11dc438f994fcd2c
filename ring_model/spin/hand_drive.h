#pragma once

#include "ring_model/moment_balance.h"
#include "ring_model/orbit_speed_table.h"
#include "ring_model/spin/sample.h"
#include "ring_model/yaw_motion.h"

#include <functional>
#include <vector>

namespace stemware::ring
{
/// Returns the yaw torque for yaw_motion() under an orbit speed table: a first-harmonic load in quasi-static
/// balance, including the hand's tangential force m dv/dt (`hand` and `full`). @p radius: ring radius [m].
/// Throws std::invalid_argument if the motion or the radius is not allowed.
PhasedTorqueFunction driven_torque(Closure closure, const Motion &motion, double radius,
                                   OrbitSpeedTable speeds);

/// Load of a glass whose orbit is @p now at the time @p time [s], at the spin @p omega [rad/s].
using DrivenLoad = std::function<Sample(const Motion &now, double time, double omega)>;

/// Returns the yaw torque of friction and lean for driven_motion() under @p load.
PhasedTorqueFunction driven_torque(const Motion &motion, OrbitSpeedTable speeds, DrivenLoad load);

/// Integrates yaw_motion() from rest under @p torque and @p grip [N m] while the hand follows @p speeds, from
/// rest too. The spin is 0 until v is (accuracy / 10)^(1/3) of the largest speed: until then a free spin,
/// which grows with v^3 (docs/theory/dynamics.md), is below @p accuracy. Uses the inertia of @p motion, and v
/// / R with @p radius [m] as the scale of spins.
std::vector<YawSample> driven_motion(const PhasedTorqueFunction &torque, const OrbitSpeedTable &speeds,
                                     const Motion &motion, double grip, double radius,
                                     const std::vector<double> &times, double accuracy);

/// Returns the absolute changes [rad/s] of driven_motion()'s spin at @p times if @p speeds are joined by
/// straight lines instead of the monotone cubic, for a first-harmonic load on a rigid ring of @p radius [m].
std::vector<double> interpolation_changes(Closure closure, const Motion &motion, double grip, double radius,
                                          const OrbitSpeedTable &speeds, const std::vector<double> &times);

/// Instant at which a resting glass begins to slide under a growing force of the hand.
struct Breakaway
{
  double time;   ///< time at which the hand starts [s]
  Motion motion; ///< motion at that time, with the static friction coefficient and without an acceleration
  double force;  ///< force of the hand, along the motion to come [N]
  double moment_ratio; ///< |M_N| / (N R / 2); from 2 on the glass tips first
};

/// Returns the breakaway of a rigid ring of @p radius [m] whose hand starts from rest. @p static_friction:
/// its coefficient; 0: coefficient of the law at rest.
Breakaway find_breakaway(Closure closure, const Motion &motion, double static_friction, double radius,
                         const OrbitSpeedTable &speeds);
} // namespace stemware::ring
