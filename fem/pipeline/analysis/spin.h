#pragma once

#include "fem/pipeline/analysis/spin_row.h"
#include "fem/pipeline/coupling/balanced_load.h"
#include "ring_model/yaw_motion.h"

#include <exception>
#include <optional>
#include <vector>

namespace stemware::pipeline
{

/// Question about the spin of a glass under a load.
struct SpinQuestion
{
  ring::Motion motion;
  double grip_torque = 0; ///< of the fingers, against the spin [N m]
  /// Nominal radius R of moment ratios [m]; nothing: that of the load's one ring.
  std::optional<double> contact_radius = {};
  double expected =
    0; ///< where the terminal spin is believed to be [rad/s]; 0: where that of the load of rest is
  /// The terminal spin of a load much like this one, where it is known.
  std::optional<ring::KnownZero> near = {};
  bool with_slope = false; ///< whether SpinRow::time_constant is wanted: it takes two more loads
  bool with_minima = true; ///< whether least loads and pulling forces are wanted: they take a while
};

/// State of the ring under @p load at the spin @p omega [rad/s]. Throws as the load.
RingState ring_state(const BalancedLoad &load, const SpinQuestion &question, double omega);

/// The spin that a load drives the ring to.
struct LongRunSpin
{
  ring::TerminalSpin
    spin = {};      ///< omega, the mean in the long run; slope and time constant of the mean torque
  double asked = 0; ///< SpinZero::asked, or omega [rad/s]
  double zero_of_mean_torque = 0; ///< [rad/s]; omega itself where the phase does not matter
  double ripple = 0;              ///< half of largest minus smallest spin in the long run [rad/s]
  /// Uncertainty of the mean spin [rad/s]: by its average, by the mean of the sampled loads, and by the loads
  /// between samples as far as ripple makes the glass stay longer at some phases.
  double uncertainty = 0;
};

/// The terminal spin under @p load, @p expected or not: the zero of the torque that is reached from rest, or,
/// where the load depends on the phase, the mean of the spin in the long run. Without @p with_slope slope and
/// time constant are NaN. Throws ring::NoBalance where there is none, ring::BalanceLost where the balance
/// ends on the way, and as the load.
LongRunSpin terminal_spin(const BalancedLoad &load, const ring::Motion &motion, double expected = 0,
                          bool with_slope = true, double grip_torque = 0,
                          const std::optional<ring::KnownZero> &near = {});

/// All spins within 1.5 v / R of rest at which the torques on the glass balance, lowest first, each with its
/// stability; those where the fingers hold the glass at rest included (TerminalSpin::held). Two that lie
/// closer together than v / 32 R may be missed. The search ends on either side where the load has no balance,
/// and at 1.05 v / R where friction brakes under any load from there on. Nothing where the load depends on
/// the phase.
std::vector<ring::TerminalSpin> all_terminal_spins(const BalancedLoad &load, const ring::Motion &motion,
                                                   double grip_torque = 0);

/// Torque of fingers that resist @p torque, or the spin @p omega [rad/s], with up to @p grip [N m]: at rest
/// as much as there is to resist.
double grip_torque(double torque, double omega, double grip);

/// @p torque and grip_torque() [N m].
double against_grip(double torque, double omega, double grip);

/// Friction's tau_z and the lean torque, mean over the phases; the grip is not in it [N m].
double yaw_torque(const BalancedLoad &load, const ring::Motion &motion, double omega);

/// Friction, lean and grip torque together [N m] at time t [s], yaw angle [rad] and spin [rad/s]; time and
/// yaw angle matter where the phase does. Its zero is the terminal spin.
ring::PhasedTorqueFunction torque_function(const BalancedLoad &load, const ring::Motion &motion,
                                           double grip_torque = 0);

/// Friction of the table on the ring under @p load at @p omega [rad/s], mean over the phases.
ring::Wrench wrench(const BalancedLoad &load, const ring::Motion &motion, double omega);

/// Friction's tau_z under @p load at the spins @p omega [rad/s, N m]; NaN where it has no balance, and @p
/// reason says why.
std::vector<double> friction_torques(const BalancedLoad &load, const ring::Motion &motion,
                                     const std::vector<double> &omega, std::string &reason);

/// Answers the question for @p load. A glass that stands at rest and tips on the way is an answer: the row
/// has no terminal spin but a SpinRow::fall. Throws ring::NoBalance where there is no terminal spin
/// otherwise, and as the load.
SpinRow spin_row(const BalancedLoad &load, const SpinQuestion &question);

/// spin_row() that does not throw for ring::NoBalance and fem::ContactFailure: what there is, with the
/// standing and the reason for what is missing.
SpinRow attempt_spin_row(const BalancedLoad &load, const SpinQuestion &question);

/// @p row, as far as it has got, with @p failure as the reason why it got no further.
SpinRow failed_row(const std::exception_ptr &failure, SpinRow row = {});

/// Equally spaced times from 0 to @p end [s]: 201 of them.
std::vector<double> output_times(double end);

/// omega(t) and psi(t) from rest under @p load at @p times.
std::vector<ring::YawSample> spin_up(const ring::PhasedTorqueFunction &torque, const ring::Motion &motion,
                                     const std::vector<double> &times, double spin_scale);

/// spin_up() under the torque_function() of @p load.
std::vector<ring::YawSample> spin_up(const BalancedLoad &load, const ring::Motion &motion,
                                     const std::vector<double> &times, double grip_torque = 0);

/// How a place of the rim slips over the table, and the friction on it: x along the direction of travel, y to
/// the left.
struct RimSlip
{
  double azimuth = 0;                    ///< theta [rad]
  double slip_x = 0, slip_y = 0;         ///< velocity over the hand's speed
  double friction_x = 0, friction_y = 0; ///< per angle, over that of the mean load at rest
};

/// Slip and friction of the load, as far as it presses, at 24 places of a rim of this @p radius [m] that
/// spins with @p omega [rad/s].
std::vector<RimSlip> rim_slip(const ring::Motion &motion, double radius, const ring::RingStack &load,
                              double omega);

} // namespace stemware::pipeline
