#pragma once

#include "ring_model/friction_functionals.h"
#include "ring_model/load/ring_stack.h"
#include "ring_model/moment_balance.h"
#include "ring_model/terminal_spin.h"

#include <optional>
#include <string>
#include <vector>

namespace stemware::pipeline
{

/// State of the ring under a load, or why there is no answer.
enum class Standing
{
  full_contact,    ///< the whole land is under pressure
  lift_off,        ///< a part of the land is not under pressure
  formal,          ///< the load, or what is left of it, would have to pull on the table
  tips,            ///< no load that only pushes carries the moment
  no_balance,      ///< no balance of moments was found
  no_terminal_spin ///< the torque does not vanish
};

/// "full contact", "lift-off", "formal", "tips", "no balance", "no terminal spin".
std::string to_string(Standing standing);

/// One load at one spin.
struct RingState
{
  ring::RingStack load;       ///< its harmonics that act on the ring
  ring::Wrench friction = {}; ///< T and tau_z
  double lean_torque = 0;     ///< of the normal forces on the leaning glass, LeaningLoad::lean_torque() [N m]
  double grip_torque = 0;     ///< of the fingers, grip_torque() [N m]
  double moment_ratio = 0;    ///< |M_N| / (N R / 2) with SpinQuestion::contact_radius
  double minimum = 0;         ///< least value of lambda [N/rad]
  double pulling_share = 0;   ///< what the table would have to pull with, over N

  /// Friction, lean and grip torque together: I d omega / dt, zero at a terminal spin [N m].
  double torque() const { return friction.torque + lean_torque + grip_torque; }
};

/// Where a glass that stands at rest falls over.
struct Fall
{
  double omega;    ///< the last spin in balance, known to v / (4096 R) [rad/s]
  RingState state; ///< at that spin
};

/// The answer to the one question of the project: what spin does this load give, with these of its harmonics?
/// Rows of run, truncate, sweep and converge. What does not exist is missing, and `standing` says
/// why.
struct SpinRow
{
  unsigned int harmonics = 0; ///< that act on the ring

  std::optional<RingState> at_rest;
  std::optional<ring::TerminalSpin> terminal;
  double ripple = 0; ///< half of largest minus smallest spin in the long run [rad/s]; 0 without phases
  double spin_uncertainty = 0;    ///< of the mean in the long run, LongRunSpin::uncertainty [rad/s]
  double zero_of_mean_torque = 0; ///< [rad/s]; the terminal spin itself where the phase does not matter
  std::optional<RingState> at_terminal;
  std::optional<Fall>
    fall; ///< nothing unless the glass stands at rest and tips on its way to a terminal spin
  std::optional<double> band = {};  ///< half-width of the error band of the terminal spin [rad/s]
  std::vector<double> torques = {}; ///< tau_z at the spins asked for [N m]; NaN where there is no balance
  Standing standing = Standing::no_balance;
  std::string reason = {}; ///< why something is missing; empty where nothing is

  // Beside another row:
  std::optional<double>
    relative_change = {}; ///< of the terminal spin to that of all harmonics; nothing if that is 0
  std::optional<double>
    bound = {}; ///< a priori, on the change of tau_z at the terminal spin of all harmonics [N m]

  std::optional<double> omega_terminal() const; ///< [rad/s]
  /// The terminal spin, or that of the fall [rad/s]; nothing where the row has neither.
  std::optional<double> last_spin() const;
  /// I_z / |d tau_z / d omega| at the terminal spin [s]; nothing where there is none, or the slope is 0.
  std::optional<double> time_constant() const;
  /// Whether the load is negative somewhere, at rest or at the terminal spin.
  bool pulls() const;
};

} // namespace stemware::pipeline
