#pragma once

#include "ring_model/terminal_spin.h"

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
 * Spin-up I_z d omega/dt = tau_z(omega) by the paper's forward Euler: omega_{i+1} = omega_i + tau_z(omega_i)
 * dt / I_z. First order in @p time_step. Returns n_steps + 1 samples, the first at t = 0.
 *
 * @throws std::invalid_argument if the inertia or the step is not positive.
 */
std::vector<SpinSample> spin_up_euler(const TorqueFunction &torque, double yaw_inertia, double initial_spin,
                                      double time_step, unsigned int n_steps);

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

/**
 * The time [s] after which the spin stays within @p fraction of the whole change |terminal - initial| of its
 * terminal value: int I_z / tau_z domega, by Gauss-Kronrod quadrature to rounding.
 *
 * @throws std::invalid_argument unless 0 < fraction < 1,
 *         std::runtime_error if the torque does not push from the initial to the terminal spin all the way.
 */
double settling_time(const TorqueFunction &torque, double yaw_inertia, double initial_spin,
                     double terminal_omega, double fraction);
} // namespace stemware::ring
