#pragma once

#include "ring_model/no_balance.h"

#include <functional>
#include <optional>

namespace stemware::ring
{
/// Yaw torque tau_z [N m] at the spin omega [rad/s].
using TorqueFunction = std::function<double(double omega)>;

/// Options of the search for the spin at which a costly torque vanishes.
struct SpinSearch
{
  double spin_scale;                        ///< spin at which the torque varies, v / R [rad/s]
  std::optional<double> initial_guess = {}; ///< where the zero is believed to be [rad/s]
  double grip_torque = 0.; ///< tau_g >= 0 of the fingers [N m], which the table has to overcome
  /// Tolerance of omega, relative to |omega| or, if larger, to 1e-3 spin_scale; not smaller than what the
  /// noise of the torque allows.
  double tolerance = 1e-12;
  /// Noise of the torque at rest [N m]: one no larger moves nothing, so that rest, stable or not, is the
  /// answer.
  double torque_noise = 0.;
  /// Steadiness of the balance at a spin that the torque has been asked for: 1 where the glass stands
  /// upright, 0 where its balance ends, and falling towards that like the root of the distance. Empty: not
  /// known.
  std::function<double(double omega)> stability_margin = {};
  /// Spin nearest to rest on the way to @p omega that is known to have no balance, if any is. Empty: none
  /// is known.
  std::function<std::optional<double>(double omega)> nearest_unbalanced_spin = {};
};

/// Spin at which the torques on the glass balance.
struct SpinZero
{
  double omega;               ///< [rad/s]
  bool held;                  ///< |tau_z(0)| <= tau_g, tau_g > 0: the fingers keep the glass at rest
  unsigned int n_evaluations; ///< of the torque
  double asked;               ///< where the torque was asked for, at the zero or within 1e-7 of it [rad/s]
};

/**
 * Terminal spin that is reached from rest: the first zero of torque(omega) - tau_g sgn(omega) in the
 * direction of torque(0). The fingers hold the glass if |torque(0)| <= tau_g; it rests where |torque(0)| is
 * no larger than its noise.
 *
 * The search steps outwards, first to the spin that is expected, until the torque changes sign or inverse
 * interpolation (up to cubic) has converged; proposals outside the bracket, and those after a step that did
 * not halve the torque, are replaced by bisection. It ends when the interpolations with and without the
 * sample farthest away agree to the tolerance. A pair of zeros that lies between neighbouring samples is not
 * seen, but there is a sample about halfway, and where the samples up to the zero do not fall, or fall near
 * the zero sixteen times more or less steeply than on average, the way to it is scanned in steps of 1/16
 * spin_scale, and the first zero that the scan meets is taken.
 *
 * If @p torque throws NoBalance the search steps back towards rest. A range of spins without a balance may
 * be narrower than the steps of the search: where the stability margin is below 0.9 the way to the zero is
 * looked at more closely, with up to 100 torques, until it tells that the balance holds or has ended.
 * @throws std::invalid_argument for values that are not allowed, NoTerminalSpin if the torque does not change
 * sign within 64 spin scales, BalanceLost if the balance ends before a zero is found (known to 1/4096 spin
 * scale), NoBalance if the search does not converge, what @p torque throws at rest.
 */
SpinZero find_terminal_spin(const TorqueFunction &torque, const SpinSearch &search);

/// Stable zero of a torque much like the one in question.
struct ZeroGuess
{
  double omega; ///< [rad/s], not 0
  double slope; ///< d tau_z / d omega there [N m s], < 0
};

/**
 * find_terminal_spin() next to the zero of another torque that differs little, by the secant method: one to
 * four evaluations. A last step that is known to the tolerance is not evaluated. The zero found is the one
 * that the search from rest would find as long as the torques differ too little for others to appear. Nothing
 * where the method leaves the neighbourhood (a tenth of spin_scale), does not end in eight steps, or comes to
 * a balance of little stability margin, the way to which has to be looked at.
 * @throws what @p torque throws.
 */
std::optional<SpinZero> find_terminal_spin_near(const ZeroGuess &known, const TorqueFunction &torque,
                                                const SpinSearch &search);
} // namespace stemware::ring
