#pragma once

#include "ring_model/load/ring_stack.h"
#include "ring_model/motion.h"
#include "ring_model/spin_search.h"

#include <vector>

namespace stemware::ring
{
/// A spin at which the yaw torque vanishes.
struct TerminalSpin
{
  double omega;         ///< [rad/s]
  double torque_slope;  ///< d tau_z / d omega there [N m s]
  double time_constant; ///< I_z / |slope| [s]: of the approach if stable, of the escape if not
  bool stable;          ///< slope < 0
  bool held = false;    ///< the fingers hold the glass at rest (SpinZero::held): slope and time are NaN
};

/// Step [rad/s] for differences of the torque at @p omega: 1/32 of the distance to |omega| = @p spin_scale,
/// where the torque bends sharply, between 1/4096 and 1/64 of @p spin_scale. A step this wide averages over
/// several azimuth lines while the edges of a contact with lift-off move across them.
double slope_step(double omega, double spin_scale);

/// Slope of fourth order [N m s] from the change of the torque between -@p step and @p step and the change
/// between -2 @p step and 2 @p step.
double slope_of_differences(double change, double change_of_two_steps, double step);

/// d tau_z / d omega [N m s] at @p omega by differences of fourth order: four torques within 2 @p step.
double torque_slope(const TorqueFunction &torque, double omega, double step);

/**
 * The terminal spin by find_terminal_spin(), and its torque_slope() with slope_step(). If a torque there
 * fails, as next to a fall, the step is 1/2048 spin_scale. Throws as find_terminal_spin(), and if
 * @p yaw_inertia is not positive.
 */
TerminalSpin terminal_spin(const TorqueFunction &torque, double yaw_inertia, const SpinSearch &search);

/**
 * The terminal spin that the ring reaches from rest: the first zero of @p torque in the direction in which
 * the torque pushes, as find_terminal_spin() sees it, to rounding; with a slope of eighth order.
 *
 * @param spin_scale Spin at which the torque varies, v / R [rad/s].
 * @throws std::invalid_argument if @p yaw_inertia or @p spin_scale is not positive,
 *         NoTerminalSpin if the torque does not change sign within the search.
 */
TerminalSpin terminal_spin(const TorqueFunction &torque, double yaw_inertia, double spin_scale);

/// terminal_spin() from rest under a load that does not react to the spin (a frozen load).
TerminalSpin terminal_spin(const RingStack &load, const Motion &motion);

/**
 * All zeros of @p torque in [@p lower, @p upper] in increasing order, each with its stability. Sign changes
 * over
 * @p n_intervals equal intervals are bracketed; intervals where |torque| has a minimum are searched for pairs
 * of zeros that such a scan steps over.
 *
 * @throws std::invalid_argument for an empty range or no intervals.
 */
std::vector<TerminalSpin> all_terminal_spins(const TorqueFunction &torque, double yaw_inertia, double lower,
                                             double upper, unsigned int n_intervals = 400);
} // namespace stemware::ring
