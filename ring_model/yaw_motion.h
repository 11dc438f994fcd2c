#pragma once

#include "ring_model/spin_search.h"

#include <functional>
#include <vector>

namespace stemware::ring
{
/// Yaw torque tau_z [N m] at time t [s], yaw angle psi [rad] (for waviness) and spin omega [rad/s].
using PhasedTorqueFunction = std::function<double(double time, double yaw_angle, double omega)>;

/// Callback with each time [s] at which a motion evaluates its torque. An exception ends the motion.
using TimeObserver = std::function<void(double time)>;

/// Returns @p torque with calls of @p observer; @p torque itself if @p observer is empty.
PhasedTorqueFunction observed(PhasedTorqueFunction torque, TimeObserver observer);

/// Yaw angle and spin at one time.
struct YawSample
{
  double time;      ///< [s]
  double yaw_angle; ///< psi [rad], 0 at t = 0
  double omega;     ///< d psi / dt [rad/s]
};

/// Returns the torque [N m] of fingers that resist @p torque or the spin @p omega [rad/s] with up to @p grip
/// [N m]; at rest it cancels @p torque up to that limit.
double grip_torque(double torque, double omega, double grip);

/// Integrates I_z d omega/dt = tau_z(t, psi, omega) - grip sgn(omega), d psi/dt = omega from psi = 0 at t = 0
/// by the Dormand-Prince pair with step control and dense output (Boost.Odeint), sampled at @p times; by
/// Radau IIA if the time constant is far below the time between outputs. A spin that reaches 0 is exactly 0
/// until |tau_z| at rest exceeds the grip. The end of a rest is bracketed by outputs, breaks and 64 parts of
/// the remaining time.
///
/// @p times: increasing output times [s], the first one >= 0. @p accuracy: tolerance of psi relative to max(1
/// rad, |psi|) and of omega relative to max(spin_scale, |omega|). @p spin_scale: typical spin, v / R [rad/s].
/// @p grip: of grip_torque() [N m]. @p breaks: increasing times [s] at which a derivative of the torque
/// jumps; a step ends at each. Throws std::invalid_argument for times out of order or values out of range,
/// std::runtime_error if the step control gives up.
std::vector<YawSample> yaw_motion(const PhasedTorqueFunction &torque, double yaw_inertia, double initial_spin,
                                  const std::vector<double> &times, double accuracy, double spin_scale,
                                  double grip = 0., const std::vector<double> &breaks = {});

/// Returns the motion at @p times [s] after @p start, braked by the fingers with @p grip [N m]. Other
/// arguments as in yaw_motion(), but not checked. The torque is not evaluated after the last time.
std::vector<YawSample> gripped_motion(const YawSample &start, const PhasedTorqueFunction &torque,
                                      double yaw_inertia, const std::vector<double> &times, double accuracy,
                                      double spin_scale, double grip, const std::vector<double> &breaks = {});

/// Integrates the equations of yaw_motion() by forward Euler, as in the paper, from t = 0 and psi = 0 in @p
/// n_steps steps of @p time_step [s]. Returns n_steps + 1 samples. First order in @p time_step. Throws
/// std::invalid_argument if the inertia or the step is not positive.
std::vector<YawSample> yaw_motion_euler(const PhasedTorqueFunction &torque, double yaw_inertia,
                                        double initial_spin, double time_step, unsigned int n_steps,
                                        double grip = 0.);

/// Returns mean, ripple and uncertainty (the change of the mean from one window to the next) of the spin
/// after the transient. Follows the motion from psi = 0 and @p initial_spin through windows of time until
/// their means agree. The weight exp(-1 / (s (1 - s))), 0 < s < 1, over a window makes means of
/// (quasi-)periodic motions converge faster than any power of the window's length (Das, Saiki, Sander &
/// Yorke, Nonlinearity 30 (2017) 4111).
///
/// @p window: initial length of a window [s], about twelve slowest periods of the motion; doubled at most
/// twice. @p accuracy: tolerance of the mean relative to @p spin_scale. If the longest windows differ by
/// more, their difference is the uncertainty of the result. Throws std::invalid_argument for values out of
/// range, std::runtime_error if the longest windows differ by more than 1e-5 of @p spin_scale, or as
/// yaw_motion().
TerminalSpin long_time_spin(const PhasedTorqueFunction &torque, double yaw_inertia, double initial_spin,
                            double window, double accuracy, double spin_scale, double grip = 0.);
} // namespace stemware::ring
