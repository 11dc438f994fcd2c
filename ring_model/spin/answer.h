#pragma once

#include "ring_model/friction_functionals.h"
#include "ring_model/load/ring_stack.h"
#include "ring_model/motion.h"
#include "ring_model/spin/load.h"
#include "ring_model/terminal_spin.h"
#include "ring_model/yaw_motion.h"

#include <exception>
#include <optional>
#include <string>

namespace stemware::ring
{
/// Question about the terminal spin of a glass under a load.
///
///     const RingStack rings({ 0.5, 0. }, { 0., 0.2 }, 0.03); // [N/rad], [m]
///     const Load load([&](double) -> Sample { return rings; });
///     const Answer found = answer(load, { Motion() });
///     found.omega_terminal(); // [rad/s]; std::nullopt: see found.reason
struct Question
{
  Motion motion;
  double grip_torque = 0.; ///< grip of the fingers, against the spin [N m]
  /// Nominal radius R of moment ratios [m]; std::nullopt: the radius of the load's single ring.
  std::optional<double> contact_radius = {};
  double initial_guess = 0.; ///< initial guess of the terminal spin [rad/s]; 0: from the load at rest
  /// Terminal spin of a similar load with a negative slope, for a local search; std::nullopt: search from
  /// rest.
  std::optional<TerminalSpin> zero_guess = {};
  bool with_slope = false;    ///< compute slope and time constant: four more loads
  TimeObserver observer = {}; ///< called during long runs and spin-ups
};

/// Status of an answer: state of the contact, or the kind of failure.
enum class Status
{
  full_contact,    ///< the whole land is under pressure
  lift_off,        ///< a part of the land is free of pressure
  formal,          ///< the load, or its truncation, is negative somewhere (tensile, not physical)
  tips,            ///< no compressive load has the required moment
  no_balance,      ///< no balance of moments was found
  no_terminal_spin ///< the torque does not vanish
};

/// Returns "full contact", "lift-off", "formal", "tips", "no balance" or "no terminal spin".
std::string to_string(Status status);

/// Torques on the glass at one spin, means over the phases; NaN without a balance.
struct Torques
{
  Wrench friction = {};    ///< T and tau_z
  double lean_torque = 0.; ///< torque of the normal forces, Sample::lean_torque() [N m]
  double grip_torque = 0.; ///< torque of the fingers, grip_torque() [N m]

  /// Returns I d omega / dt: the sum of friction, lean and grip torque; zero at a terminal spin [N m].
  double torque() const { return friction.torque + lean_torque + grip_torque; }
};

/// One load at one spin.
struct RingState : Torques
{
  RingStack load;            ///< truncated to the harmonics that act on the ring
  double moment_ratio = 0.;  ///< |M_N| / (N R / 2) with Question::contact_radius
  double minimum = 0.;       ///< minimum of lambda [N/rad]
  double pulling_share = 0.; ///< RingStack::pulling_force() over N
  double omega = 0.;         ///< [rad/s]
};

/// Returns the torques of @p question under @p load, the load at the spin @p omega [rad/s].
Torques torques_at(const Sample &load, const Question &question, double omega);

/// Returns the state of the ring under @p load, the load at the spin @p omega [rad/s].
RingState ring_state(const Sample &load, const Question &question, double omega);

/// Answer to a Question about a load or its truncation. Missing quantities are std::nullopt or empty;
/// `status` and `reason` give the cause.
struct Answer
{
  unsigned int harmonics = 0; ///< harmonics that act on the ring

  std::optional<RingState> at_rest;
  /// With phases: the mean spin after the transient. TerminalSpin::uncertainty adds the errors of the
  /// average, of the mean of the sampled loads, and of the loads between samples weighted by the ripple.
  std::optional<TerminalSpin> terminal;
  std::optional<RingState> at_terminal;
  /// State at the last spin in balance, located to v / (4096 R). std::nullopt unless the glass stands at rest
  /// and tips before a terminal spin.
  std::optional<RingState> fall;
  Status status = Status::no_balance;
  std::string reason = {};              ///< cause of missing quantities; empty if none is missing
  std::exception_ptr failure = nullptr; ///< exception behind the reason; nullptr if the glass tips on the way

  /// Change of the terminal spin relative to the full load's, by compared_with_all(); std::nullopt over 0.
  std::optional<double> relative_change = {};

  std::optional<double> omega_terminal() const; ///< [rad/s]
  /// Returns the terminal spin, or the spin at which the glass tips [rad/s]; std::nullopt without either.
  std::optional<double> last_spin() const;
  /// Returns I_z / |d tau_z / d omega| at the terminal spin [s]; std::nullopt without it or without a slope.
  std::optional<double> time_constant() const;
  /// Returns the terminal spin as an initial guess for similar loads; std::nullopt if the spin is missing or
  /// 0, or its slope is not known to be negative.
  std::optional<TerminalSpin> zero_guess() const;
  /// Returns whether the load is negative somewhere, at rest or at the terminal spin.
  bool pulls() const;
  /// Throws `failure`, if there is one.
  const Answer &value() const;
};

/// Answers @p question about @p load. Does not throw NoBalance, but reports it in Answer::reason.
Answer answer(const Load &load, const Question &question);

/// Returns the incomplete @p answer with @p failure as the reason for its missing quantities.
Answer failed_answer(const std::exception_ptr &failure, Answer answer = {});

/// Returns @p answer, of a truncation of @p load, with the change of the terminal spin relative to @p all,
/// the answer of the full load. With phases, RingState::minimum is the minimum over all of them.
Answer compared_with_all(Answer answer, const Answer &all, const Load &load, const Motion &motion);

/// Returns whether the harmonics above @p n_harmonics are negligible at the terminal spin of @p all: the
/// bound on their torque is below 1/10 of the search's tolerance.
bool are_negligible_above(unsigned int n_harmonics, const Answer &all, const Motion &motion);

/// Returns tau_z of friction plus lean torque [N m] under @p load, the load at the spin @p omega [rad/s].
double yaw_torque(const Sample &load, const Motion &motion, double omega);

/// Returns yaw_torque() at @p marks; without @p marks, of the mean over the phases.
double yaw_torque(const Load &load, const Motion &motion, double omega,
                  const std::optional<Orientation> &marks = {});
} // namespace stemware::ring
