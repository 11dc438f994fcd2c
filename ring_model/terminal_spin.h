#pragma once

#include "ring_model/load/ring_stack.h"
#include "ring_model/motion.h"
#include "ring_model/spin_search.h"

#include <optional>
#include <vector>

namespace stemware::ring
{
/// Returns the step [rad/s] for torque differences at @p omega: 1/32 of the distance to the kink at |omega| =
/// @p spin_scale, within 1/4096 ... 1/64 of @p spin_scale. A step this wide averages over several azimuth
/// lines, which the edges of a contact with lift-off cross.
double slope_step(double omega, double spin_scale);

/// Returns the fourth-order slope [N m s] from the torque's changes over -+@p step and -+2 @p step.
double slope_of_differences(double change, double change_of_two_steps, double step);

/// Returns d tau_z / d omega [N m s] at @p omega by fourth-order differences: four torques within 2 @p step.
double torque_slope(const TorqueFunction &torque, double omega, double step);

/// Returns the zero of find_terminal_spin() and the torque_slope() over slope_step(), or over 1/2048
/// spin_scale if a torque fails, as near tipping. Throws as find_terminal_spin(), and unless @p yaw_inertia
/// is positive.
TerminalSpin terminal_spin(const TorqueFunction &torque, double yaw_inertia, const SpinSearch &search);

/// Finds the terminal spin near @p known, the stable terminal spin of a similar torque with its slope, by the
/// secant method, with one to four evaluations. The result equals find_terminal_spin() if no further zeros
/// have appeared. Returns std::nullopt if the method leaves the neighbourhood (a tenth of spin_scale), does
/// not converge, or reaches a spin of small stability margin. Throws what @p torque throws.
std::optional<TerminalSpin> find_terminal_spin_near(const TerminalSpin &known, const TorqueFunction &torque,
                                                    const SpinSearch &search);

/// Returns terminal_spin() from rest under a load that does not depend on the spin, to rounding.
TerminalSpin terminal_spin(const RingStack &load, const Motion &motion);

/// Returns all zeros of @p torque in [@p lower, @p upper] in ascending order, each as by terminal_spin().
/// Sign changes over @p n_intervals equal intervals are bracketed; minima of |torque| are searched for pairs
/// of zeros. Throws std::invalid_argument for an empty range or no intervals.
std::vector<TerminalSpin> all_terminal_spins(const TorqueFunction &torque, double yaw_inertia,
                                             double spin_scale, double lower, double upper,
                                             unsigned int n_intervals = 400);
} // namespace stemware::ring
