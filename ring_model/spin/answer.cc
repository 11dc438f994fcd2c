#include "ring_model/spin/answer.h"

#include "ring_model/failures.h"
#include "ring_model/friction_functionals.h"
#include "ring_model/load/require.h"
#include "ring_model/spin/curves.h"
#include "ring_model/spin/phase_loads.h"
#include "ring_model/yaw_motion.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace stemware::ring
{
namespace
{
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
/// Returns the averaging window [s]: max(16 T, 8 tau) with the longest period T and the decay time tau. The
/// period of the glass is limited, because it diverges if the glass turns at the rate of the orbit.
double averaging_window(const PhasePeriods &periods, const Motion &motion, const TerminalSpin &terminal)
{
  const double orbit = std::abs(motion.orbit_rate());
  double slowest = periods.table / orbit;
  if (periods.glass > 0)
    slowest = std::max(slowest,
                       periods.glass / std::max(std::abs(terminal.omega - motion.orbit_rate()), 0.1 * orbit));
  return std::max(16 * slowest, 8 * std::min(terminal.time_constant, 100 / orbit));
}

/// Returns the terminal spin with the load at one phase, an initial guess that needs few contact solves.
std::optional<double> spin_at_first_phase(const PhaseSampledLoad &phases, const Motion &motion,
                                          const SpinSearch &search)
{
  const auto torque = [&](double omega) { return yaw_torque(phases.at_first_phase(omega), motion, omega); };
  const std::optional<double> spin =
    find_or_nullopt([&] { return find_terminal_spin(torque, search).omega; });
  return spin && *spin != 0 ? spin : std::nullopt;
}

/// Replaces the terminal spin of @p found, a zero of the mean torque, by the long-time mean of the spin.
void take_long_run_mean(const Load &load, const Question &question, double spin_scale, Answer &found)
{
  const PhaseSampledLoad &phases = *load.phases();
  const Motion &motion = question.motion;
  TerminalSpin &spin = *found.terminal;
  // Inertia reduces the ripple, so the spin remains between the extreme zeros of the torques at fixed phases.
  double largest_torque = 0;
  for (unsigned int i = 0; i < phases.phases().size(); ++i)
    largest_torque =
      std::max(largest_torque, std::abs(yaw_torque(load, motion, spin.omega, phases.phases().phase(i))));
  const double slope = spin.held ? 0 : std::abs(spin.torque_slope),
               reach = slope > 0 ? 2 * largest_torque / slope : 0.01 * spin_scale;
  // Accuracy of the mean spin: a tenth of the error of the load interpolated in the phase, but at most the
  // maximum of 1e-3 and the error of the mean load.
  constexpr double coarsest = 1e-3;
  const SampleError known = phases.error(spin.omega - reach, spin.omega + reach);
  const double accuracy = std::clamp(0.1 * known.between, 1e-9, std::max(coarsest, known.mean));
  const double friction_torque = motion.friction_at_rest() * motion.normal_force() * load.radius(),
               torque_scale = slope > 0 ? slope * spin_scale : friction_torque;
  const PhasedTorqueFunction torque =
    tabulated_torque(load, motion, spin.omega, reach, 0.03 * accuracy * torque_scale);
  const TerminalSpin mean = long_time_spin(observed(torque, question.observer), motion.yaw_inertia,
                                           spin.omega, averaging_window(phases.periods(), motion, spin),
                                           accuracy, spin_scale, question.grip_torque);
  spin.omega = mean.omega;
  spin.ripple = mean.ripple;
  // The error of the load interpolated in the phase averages out unless the ripple keeps the glass longer at
  // some phases. The factor `longer` estimates the part of this error that remains.
  const double turning = std::abs(mean.omega - motion.orbit_rate());
  const double longer = phases.phases().glass.size() == 1 ? 0
                        : mean.ripple < turning           ? mean.ripple / turning
                                                          : 1;
  const auto [of_mean, between] = phases.error(mean.omega - mean.ripple, mean.omega + mean.ripple);
  const double torque_error =
    (of_mean + longer * between) * motion.friction_coefficient * motion.normal_force() * load.radius();
  spin.uncertainty = mean.uncertainty;
  if (!spin.held)
    spin.uncertainty += torque_error / std::abs(spin.torque_slope);
}

/// Adds the terminal spin to @p found, or its long-time mean if the load depends on the phase.
void find_terminal(const Load &load, const Question &question, Answer &found)
{
  const Motion &motion = question.motion;
  const auto torque = [&](double omega) { return yaw_torque(load, motion, omega); };
  SpinSearch search;
  search.spin_scale = load.spin_scale(motion);
  search.tolerance = 1e-11; // a tenth of the maximum relative error of a contact solution
  search.initial_guess = question.initial_guess != 0
                           ? question.initial_guess
                           : find_or_nullopt([&] { return terminal_spin(load.at(0), motion).omega; });
  search.grip_torque = question.grip_torque;
  search.stability_margin = [&load](double omega) { return load.stability_margin(omega); };
  search.nearest_unbalanced_spin = [&load](double omega) { return load.nearest_unbalanced_spin(omega); };
  // If the torque at rest is zero (hand at the centre of mass), rounding must not determine the direction.
  search.torque_noise = 1e-9 * motion.friction_at_rest() * motion.normal_force() * load.radius();
  if (const PhaseSampledLoad *phases = load.phases())
    if (const std::optional<double> near = spin_at_first_phase(*phases, motion, search))
      search.initial_guess = near;
  if (question.with_slope || load.phases())
    found.terminal = terminal_spin(torque, motion.yaw_inertia, search);
  else
  {
    if (question.zero_guess)
      found.terminal = find_terminal_spin_near(*question.zero_guess, torque, search);
    if (!found.terminal)
      found.terminal = find_terminal_spin(torque, search);
    found.terminal->torque_slope = nan; // a secant's slope is not accurate enough
  }
  if (load.phases())
    take_long_run_mean(load, question, search.spin_scale, found);
}

/// Fills @p found with the terminal spin, or with the spin at which the glass tips.
void find_spin(const Load &load, const Question &question, Answer &found)
{
  found.harmonics = load.n_harmonics();
  found.at_rest = ring_state(load.at(0), question, 0);
  Answer searched = found; // `found` must contain no terminal spin if the glass tips
  try
  {
    find_terminal(load, question, searched);
  }
  catch (const BalanceLost &lost)
  {
    if (!lost.tips())
      throw;
    found.status = Status::tips;
    found.fall = ring_state(load.at(lost.last_spin), question, lost.last_spin);
    found.reason =
      sentence("the glass stands at rest and tips while it spins up, at ", rounded_text(found.fall->omega, 3),
               " rad/s and a moment ratio of ", rounded_text(found.fall->moment_ratio, 3));
    return;
  }
  found = searched;
  const double evaluated_at = found.terminal->evaluated_at;
  found.at_terminal = ring_state(load.at(evaluated_at), question, evaluated_at);
  found.status = found.at_terminal->minimum < 0 ? Status::formal : Status::full_contact;
}

} // namespace

std::string to_string(Status status)
{
  static constexpr const char *names[] = { "full contact", "lift-off",   "formal",
                                           "tips",         "no balance", "no terminal spin" };
  return names[static_cast<std::size_t>(status)];
}

Torques torques_at(const Sample &load, const Question &question, double omega)
{
  const Wrench friction = wrench(question.motion, load, omega);
  const double lean_torque = load.lean_torque();
  return { friction, lean_torque, grip_torque(friction.torque + lean_torque, omega, question.grip_torque) };
}

RingState ring_state(const Sample &load, const Question &question, double omega)
{
  RingState state = { torques_at(load, question, omega), load };
  state.moment_ratio = load.moment_ratio(question.contact_radius.value_or(load.radius()));
  state.minimum = load.minimum();
  state.pulling_share = state.minimum < 0 ? load.pulling_force() / load.normal_force() : 0;
  state.omega = omega;
  return state;
}

std::optional<double> Answer::omega_terminal() const
{
  return terminal ? std::optional(terminal->omega) : std::nullopt;
}

std::optional<double> Answer::last_spin() const
{
  return terminal ? std::optional(terminal->omega) : fall ? std::optional(fall->omega) : std::nullopt;
}

std::optional<double> Answer::time_constant() const
{
  return terminal && std::isfinite(terminal->time_constant) ? std::optional(terminal->time_constant)
                                                            : std::nullopt;
}

std::optional<TerminalSpin> Answer::zero_guess() const
{
  const bool is_usable = terminal && terminal->torque_slope < 0 && terminal->omega != 0;
  return is_usable ? terminal : std::nullopt;
}

bool Answer::pulls() const
{
  return (at_rest && at_rest->minimum < 0) || (at_terminal && at_terminal->minimum < 0);
}

const Answer &Answer::value() const
{
  if (failure)
    std::rethrow_exception(failure);
  return *this;
}

Answer answer(const Load &load, const Question &question)
{
  Answer found;
  try
  {
    find_spin(load, question, found);
  }
  catch (const NoBalance &)
  {
    return failed_answer(std::current_exception(), std::move(found));
  }
  return found;
}

Answer failed_answer(const std::exception_ptr &failure, Answer answer)
{
  answer.failure = failure;
  answer.status = Status::no_balance;
  try
  {
    std::rethrow_exception(failure);
  }
  catch (const NoTerminalSpin &why)
  {
    answer.status = Status::no_terminal_spin;
    answer.reason = why.what();
  }
  catch (const NoBalance &why)
  {
    answer.status = why.tips() ? Status::tips : Status::no_balance;
    answer.reason = why.what();
  }
  catch (const std::exception &why)
  {
    answer.reason = why.what();
  }
  return answer;
}

Answer compared_with_all(Answer answer, const Answer &all, const Load &load, const Motion &motion)
{
  if (!all.terminal)
    return answer;
  const double omega = all.terminal->omega;
  // If the load has no moment, the terminal spin is a rounding error, and a relative change is undefined.
  const double scale = motion.orbit_speed / all.at_rest->load.radius();
  if (answer.terminal && std::abs(omega) > 1e-9 * scale)
    answer.relative_change = (answer.terminal->omega - omega) / omega + 0.; // + 0. avoids -0
  if (load.phases() && answer.at_rest)
    for (const RingStack &sample : load.phases()->samples(0))
      answer.at_rest->minimum =
        std::min(answer.at_rest->minimum, sample.truncated(answer.harmonics).minimum());
  return answer;
}

bool are_negligible_above(unsigned int n_harmonics, const Answer &all, const Motion &motion)
{
  constexpr double negligible = 1e-12; // change of the spin, relative to the terminal spin
  const std::optional<TerminalSpin> zero = all.zero_guess();
  return zero && TorqueByHarmonics(motion, all.at_terminal->load, zero->omega).bound(n_harmonics) <
                   negligible * std::abs(zero->torque_slope * zero->omega);
}

double yaw_torque(const Sample &load, const Motion &motion, double omega)
{
  return wrench(motion, load, omega).torque + load.lean_torque();
}

double yaw_torque(const Load &load, const Motion &motion, double omega,
                  const std::optional<Orientation> &marks)
{
  return yaw_torque(load.at(omega, marks), motion, omega);
}

} // namespace stemware::ring
