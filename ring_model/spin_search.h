#pragma once

#include "ring_model/failures.h"

#include <cmath>
#include <functional>
#include <optional>

namespace stemware::ring
{
/// Yaw torque tau_z [N m] at the spin omega [rad/s].
using TorqueFunction = std::function<double(double omega)>;

/// Options of find_terminal_spin(), the search for the zero of a costly torque.
struct SpinSearch
{
  double spin_scale;                        ///< spin at which the torque varies, v / R [rad/s]
  std::optional<double> initial_guess = {}; ///< of the zero [rad/s]
  double grip_torque = 0.;                  ///< tau_g >= 0 of the fingers [N m]
  /// Tolerance of omega, relative to max(|omega|, 1e-3 spin_scale); limited by the torque's noise.
  double tolerance = 1e-12;
  /// Noise of the torque at rest [N m]: if a smaller torque is found there, rest is the answer.
  double torque_noise = 0.;
  /// Stability margin at an evaluated spin: 1 for an upright glass, falling to 0 at the end of its balance
  /// like the square root of the distance. Empty: unknown.
  std::function<double(double omega)> stability_margin = {};
  /// Returns the known spin without balance nearest to rest, between 0 and @p omega. Empty: unknown.
  std::function<std::optional<double>(double omega)> nearest_unbalanced_spin = {};

  /// Spin, relative to spin_scale, below which the tolerance is absolute.
  static constexpr double least_size = 1e-3;
  static constexpr double unsteady = 0.9; ///< stability margin below which the balance may end nearby
  /// Distance of two spins, relative to spin_scale, above which rounding does not dominate the difference of
  /// their torques.
  static constexpr double rounding_distance = 1e-6;
};

/// Spin at which the torques on the glass balance.
struct TerminalSpin
{
  double omega = 0.;          ///< [rad/s]
  double torque_slope = NAN;  ///< d tau_z / d omega at `omega` [N m s]; NaN if unknown or held
  double time_constant = NAN; ///< I_z / |slope| of approach (stable) or escape [s]; NaN if unknown or held
  bool stable = true;         ///< the slope is negative or unknown
  bool held = false;          ///< the fingers keep the glass at rest: |tau_z(0)| <= tau_g, tau_g > 0
  /// Spin for the load at the terminal spin [rad/s]: `omega`; after find_terminal_spin_near(), the last
  /// evaluated spin, within 1e-7 of `omega`; with phases, the zero of the mean torque.
  double evaluated_at = omega;
  /// With phases: half the difference between the largest and the smallest spin after the transient [rad/s].
  double ripple = 0.;
  /// With phases: uncertainty of the mean spin [rad/s].
  double uncertainty = 0.;
};

/// Finds the terminal spin reached from rest: the first zero of torque(omega) - tau_g sgn(omega) in the
/// direction of torque(0). The fingers hold the glass if |torque(0)| <= tau_g; the glass stays at rest if
/// |torque(0)| does not exceed the noise.
///
/// The search steps outwards, first to the initial guess, until the torque changes sign or inverse
/// interpolation (up to cubic) has converged. Proposals outside the bracket, and proposals after a step that
/// did not halve the torque, are replaced by bisection. The search ends when the interpolations with and
/// without the farthest sample agree to the tolerance. A pair of zeros between neighbouring samples is
/// missed; a sample about halfway makes this unlikely. If the samples up to the zero do not decrease, or the
/// slopes at the zero and on average differ by more than a factor of 16, the interval is scanned in steps of
/// 1/16 spin_scale for the first zero.
///
/// If @p torque throws NoBalance, the search steps back towards rest. Below a stability margin of 0.9, up to
/// 100 further torques exclude a narrow range of spins without a balance before the zero. Throws
/// std::invalid_argument for inadmissible values, NoTerminalSpin if the torque does not change sign within 64
/// spin scales, BalanceLost if the balance ends before a zero (located to 1/4096 spin scale), NoBalance if
/// the search does not converge, what @p torque throws at rest.
TerminalSpin find_terminal_spin(const TorqueFunction &torque, const SpinSearch &search);
} // namespace stemware::ring
