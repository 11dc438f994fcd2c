#pragma once

#include "ring_model/friction_functionals.h"
#include "ring_model/load/ring_stack.h"
#include "ring_model/motion.h"
#include "ring_model/spin/load_at_spin.h"
#include "ring_model/terminal_spin.h"
#include "ring_model/yaw_motion.h"

#include <exception>
#include <optional>
#include <string>
#include <vector>

namespace stemware::ring
{
struct Answer;

/// Question about the spin of a glass under a load.
///
///     const RingStack rings({ 0.5, 0. }, { 0., 0.2 }, 0.03); // [N/rad], [m]
///     const LoadFromFunction load([&](double) -> LeaningLoad { return rings; });
///     const Answer found = answer(load, { Motion() });
///     found.omega_terminal(); // [rad/s]; std::nullopt: see found.reason
struct Question
{
  Motion motion;
  double grip_torque = 0.; ///< of the fingers, against the spin [N m]
  /// Nominal radius R of moment ratios [m]; std::nullopt: that of the load's one ring.
  std::optional<double> contact_radius = {};
  double initial_guess = 0.; ///< initial guess of the terminal spin [rad/s]; 0: that of the load of rest
  /// Terminal spin of a similar load, if it is known.
  std::optional<ZeroGuess> near = {};
  bool with_slope = false; ///< whether slope and time constant are wanted: they take four more loads
  bool with_minima = true; ///< whether least loads and pulling forces are wanted: they take a while

  /// Answer about the same load, for which the questions below are asked; nullptr: the terminal spin is
  /// searched for first.
  const Answer *known = nullptr;
  std::vector<double> spins = {}; ///< at which the torques are wanted [rad/s]
  bool all_spins = false;         ///< whether Answer::all_spins is wanted
  std::vector<double> times = {}; ///< equally spaced, at which the spin-up from rest is wanted [s]
  double euler_step = 0.;         ///< longest step of Answer::euler [s]; 0: not wanted
};

/// State of the ring under a load, or why there is no answer.
enum class Status
{
  full_contact,    ///< the whole land is under pressure
  lift_off,        ///< a part of the land is not under pressure
  formal,          ///< the load, or what is left of it, would have to pull on the table
  tips,            ///< no load that only pushes carries the moment
  no_balance,      ///< no balance of moments was found
  no_terminal_spin ///< the torque does not vanish
};

/// "full contact", "lift-off", "formal", "tips", "no balance", "no terminal spin".
std::string to_string(Status status);

/// Torques on the glass at one spin, means over the phases; NaN without a balance.
struct Torques
{
  Wrench friction = {};    ///< T and tau_z
  double lean_torque = 0.; ///< of the normal forces on the leaning glass, LeaningLoad::lean_torque() [N m]
  double grip_torque = 0.; ///< of the fingers: at rest as much as there is to resist [N m]

  /// Friction, lean and grip torque together: I d omega / dt, zero at a terminal spin [N m].
  double torque() const { return friction.torque + lean_torque + grip_torque; }
};

/// One load at one spin.
struct RingState : Torques
{
  RingStack load;            ///< its harmonics that act on the ring
  double moment_ratio = 0.;  ///< |M_N| / (N R / 2) with Question::contact_radius
  double minimum = 0.;       ///< least value of lambda [N/rad]
  double pulling_share = 0.; ///< what the table would have to pull with, over N
};

/// State of the ring under @p load, that of the spin @p omega [rad/s].
RingState ring_state(const LeaningLoad &load, const Question &question, double omega);

/// Fall of a glass that stands at rest.
struct Fall
{
  double omega;    ///< the last spin in balance, known to v / (4096 R) [rad/s]
  RingState state; ///< at that spin
};

/// Answer to a Question: the spin under a load, with these of its harmonics. What does not exist is missing,
/// and `status` says why.
struct Answer
{
  unsigned int harmonics = 0; ///< that act on the ring

  std::optional<RingState> at_rest;
  std::optional<TerminalSpin> terminal; ///< if the phase matters the mean of the spin in the long run
  double ripple = 0.; ///< half of largest minus smallest spin in the long run [rad/s]; 0 without phases
  /// Uncertainty of the mean spin in the long run [rad/s]: by its average, by the mean of the sampled loads,
  /// and by the loads between samples as far as ripple makes the glass stay longer at some phases.
  double spin_uncertainty = 0.;
  double zero_of_mean_torque = 0.; ///< [rad/s]; the terminal spin itself if the phase does not matter
  std::optional<RingState> at_terminal;
  std::optional<Fall> fall; ///< only if the glass stands at rest and tips on its way to a terminal spin
  std::optional<double> band = {}; ///< half-width of the error band of the terminal spin [rad/s]
  Status status = Status::no_balance;
  std::string reason = {};              ///< why something is missing; empty if nothing is
  std::exception_ptr failure = nullptr; ///< behind the reason; nullptr for a fall

  // Relative to the answer of all harmonics, compared_with_all():
  std::optional<double> relative_change = {}; ///< of the terminal spin; std::nullopt if that of all is 0
  /// A priori, on the change of tau_z at the terminal spin of all harmonics [N m].
  std::optional<double> bound = {};

  std::vector<Torques> torques = {}; ///< at Question::spins
  /// All spins within 1.5 v / R of rest at which the torques on the glass balance, lowest first, each with
  /// its stability; `terminal` and a glass held at rest included. Two that lie closer together than v / 32 R
  /// may be missed. The search ends on either side if the load has no balance, and at 1.05 v / R if friction
  /// brakes under any load from there on. Empty if the load depends on the phase.
  std::vector<TerminalSpin> all_spins = {};
  /// Spin-up from rest at Question::times, with error control and by forward Euler steps; NaN beyond a fall,
  /// empty without a balance.
  std::vector<YawSample> spin_up = {}, euler = {};

  std::optional<double> omega_terminal() const; ///< [rad/s]
  /// The terminal spin, or that of the fall [rad/s]; std::nullopt without either.
  std::optional<double> last_spin() const;
  /// I_z / |d tau_z / d omega| at the terminal spin [s]; std::nullopt without one, or if the slope is 0.
  std::optional<double> time_constant() const;
  /// The terminal spin as an initial guess for similar loads; std::nullopt without one, or without a slope.
  std::optional<ZeroGuess> zero_guess() const;
  /// Returns whether the load is negative somewhere, at rest or at the terminal spin.
  bool pulls() const;
  /// Throws `failure`, if there is one.
  const Answer &value() const;
};

/// Answers @p question about @p load. Does not throw NoBalance: the answer has what there is. A glass that
/// stands at rest and tips on the way is an answer without a terminal spin but with a fall.
Answer answer(const LoadAtSpin &load, const Question &question);

/// Returns @p answer, as far as it has got, with @p failure as the reason why it got no further.
Answer failed_answer(const std::exception_ptr &failure, Answer answer = {});

/// Relates @p answer, that of the first Answer::harmonics of @p load, to @p all, that of all of them: change
/// of the terminal spin and a-priori bound. If the phase matters, bound and least load are those of the worst
/// phase.
Answer compared_with_all(Answer answer, const Answer &all, const LoadAtSpin &load, const Motion &motion);

/// Returns whether the harmonics above @p n_harmonics of the load of @p all change neither torque nor balance
/// at its terminal spin: by a tenth of the tolerance of the search, as the bound of their torque tells.
bool are_negligible_above(unsigned int n_harmonics, const Answer &all, const Motion &motion);

/// Friction's tau_z of @p answer at Question::spins [N m].
std::vector<double> friction_torques(const Answer &answer);
/// Spins of @p samples [rad/s].
std::vector<double> spins_of(const std::vector<YawSample> &samples);

/// Torque of fingers that resist @p torque, or the spin @p omega [rad/s], with up to @p grip [N m]: at rest
/// as much as there is to resist.
double grip_torque(double torque, double omega, double grip);

/// Sum of friction's tau_z and the lean torque with the marks at @p marks, the mean over the phases if they
/// are not given; the grip is not included [N m].
double yaw_torque(const LoadAtSpin &load, const Motion &motion, double omega,
                  const std::optional<Orientation> &marks = {});

/// Equally spaced times from 0 to @p end [s]: 201 of them.
std::vector<double> output_times(double end);
} // namespace stemware::ring
