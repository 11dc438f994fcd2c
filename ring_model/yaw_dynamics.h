#pragma once

#include <functional>
#include <vector>

namespace stemware::ring
{
/// Yaw torque tau_z [N m] at time t [s] and spin omega [rad/s].
using TimedTorqueFunction = std::function<double(double time, double omega)>;

/// Spin at one time.
struct SpinSample
{
  double time;  ///< [s]
  double omega; ///< [rad/s]
};

/**
 * Spin-up I_z d omega/dt = tau_z(t, omega) from t = 0 by the Dormand-Prince pair with step control and dense
 * output (Boost.Odeint), sampled at @p times.
 *
 * @param times    Output times [s], increasing, the first one >= 0.
 * @param accuracy Requested accuracy of omega, relative to the largest of |omega| and @p spin_scale.
 * @param spin_scale Spin that counts as large, v / R [rad/s].
 * @throws std::invalid_argument for times out of order or values out of range, std::runtime_error if the step
 *         control gives up.
 */
std::vector<SpinSample> spin_up(const TimedTorqueFunction &torque, double yaw_inertia, double initial_spin,
                                const std::vector<double> &times, double accuracy = 1e-10,
                                double spin_scale = 1.);
} // namespace stemware::ring
