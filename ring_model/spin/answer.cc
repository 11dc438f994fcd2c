#include "ring_model/spin/answer.h"

#include "ring_model/friction_law.h"
#include "ring_model/load/require.h"
#include "ring_model/spin/all_spins.h"
#include "ring_model/spin/if_balanced.h"
#include "ring_model/spin/phase_loads.h"
#include "ring_model/spin/phase_torque.h"
#include "ring_model/spin/to_precision.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace stemware::ring
{
namespace
{
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double spin_up_accuracy = 1e-10; ///< of omega(t), relative to v / R

/// Time over which the mean spin is taken: a good dozen of the slowest repetition of the phase, which in a
/// glass that nearly follows its orbit may take for ever, and of the time in which the spin forgets its
/// start.
double averaging_window(const PhasePeriods &periods, const Motion &motion, const TerminalSpin &terminal)
{
  const double orbit = std::abs(motion.orbit_rate());
  double slowest = periods.table / orbit;
  if (periods.glass > 0)
    slowest = std::max(slowest,
                       periods.glass / std::max(std::abs(terminal.omega - motion.orbit_rate()), 0.1 * orbit));
  return std::max(16 * slowest, 8 * std::min(terminal.time_constant, 100 / orbit));
}

/// Where the load of rest would take the glass: a first guess. std::nullopt if it takes the glass nowhere.
std::optional<double> expected_spin(const LoadAtSpin &load, const Motion &motion)
{
  return if_balanced([&] { return terminal_spin(load.at(0), motion).omega; });
}

/// Where the load of one of the phases takes the glass: next to where their mean does, without the samples
/// that the mean takes all round. std::nullopt if it takes the glass nowhere.
std::optional<double> spin_at_first_phase(const PhaseSampledLoad &phases, const Motion &motion,
                                          const SpinSearch &search)
{
  const auto torque = [&](double omega)
  {
    const LeaningLoad at_spin = phases.at_first_phase(omega);
    return wrench(motion, at_spin, omega).torque + at_spin.lean_torque();
  };
  const std::optional<double> spin = if_balanced([&] { return find_terminal_spin(torque, search).omega; });
  return spin && *spin != 0 ? spin : std::nullopt;
}

std::string fall_sentence(const Fall &fall)
{
  return sentence("the glass stands at rest and tips while it spins up, at ", to_precision(fall.omega, 3),
                  " rad/s and a moment ratio of ", to_precision(fall.state.moment_ratio, 3));
}

/// Friction, lean and grip torque together [N m]; time and yaw angle matter if the phase does.
PhasedTorqueFunction torque_function(const LoadAtSpin &load, const Question &question)
{
  return [&](double time, double yaw_angle, double omega)
  {
    const Motion &motion = question.motion;
    const double torque = yaw_torque(load, motion, omega, orientation_of_marks(motion, time, yaw_angle));
    return torque_with_grip(torque, omega, question.grip_torque);
  };
}

/// Replaces the terminal spin of @p found, the zero of the mean torque, by the mean spin in the long run.
void take_long_run_mean(const LoadAtSpin &load, const Question &question, double spin_scale, Answer &found)
{
  const PhaseSampledLoad &phases = *load.phases();
  const Motion &motion = question.motion;
  // Finer than the loads are known would be in vain.
  constexpr double coarsest = 1e-3; // where the loads between phases are known badly, their mean is not
  const double accuracy =
    std::clamp(0.1 * phases.error().between, 1e-9, std::max(coarsest, phases.error().mean));
  TerminalSpin &spin = *found.terminal;
  // The spin swings no farther than to where the torque of a phase vanishes: inertia only holds it back.
  double largest_torque = 0;
  for (unsigned int i = 0; i < phases.phases().size(); ++i)
    largest_torque =
      std::max(largest_torque, std::abs(yaw_torque(load, motion, spin.omega, phases.phases().phase(i))));
  const double slope = spin.held ? 0 : std::abs(spin.torque_slope),
               reach = slope > 0 ? 2 * largest_torque / slope : 0.01 * spin_scale;
  const double friction_torque = motion.friction_at_rest() * motion.normal_force() * load.radius(),
               torque_scale = slope > 0 ? slope * spin_scale : friction_torque;
  const PhaseTorque torque(load, motion, spin.omega, reach, 0.03 * accuracy * torque_scale);
  const auto with_grip = [&](double time, double yaw_angle, double omega)
  { return torque_with_grip(torque(time, yaw_angle, omega), omega, question.grip_torque); };
  const LongTimeSpin mean =
    long_time_spin(with_grip, motion.yaw_inertia, spin.omega,
                   averaging_window(phases.periods(), motion, spin), accuracy, spin_scale);
  spin.omega = mean.mean;
  found.ripple = mean.ripple;
  // The mean's own error, and that between phases as far as ripple makes the glass stay longer at some.
  const double turning = std::abs(mean.mean - motion.orbit_rate());
  const double longer = phases.phases().glass.size() == 1 ? 0
                        : mean.ripple < turning           ? mean.ripple / turning
                                                          : 1;
  const double torque_error = (phases.error().mean + longer * phases.error().between) *
                              motion.friction_coefficient * motion.normal_force() * load.radius();
  found.spin_uncertainty = mean.uncertainty;
  if (!spin.held)
    found.spin_uncertainty += torque_error / std::abs(spin.torque_slope);
}

/// Adds the terminal spin to @p found, or the mean of the spin in the long run if the phase matters. Returns
/// the spin at which the load was asked for.
double find_terminal(const LoadAtSpin &load, const Question &question, Answer &found)
{
  const Motion &motion = question.motion;
  const auto torque = [&](double omega) { return yaw_torque(load, motion, omega); };
  SpinSearch search;
  search.spin_scale = load.spin_scale(motion);
  search.tolerance = 1e-11; // contacts are good to 1e-10 of the load or better
  search.initial_guess = question.initial_guess != 0 ? question.initial_guess : expected_spin(load, motion);
  search.grip_torque = question.grip_torque;
  search.stability_margin = [&load](double omega) { return load.stability_margin(omega); };
  search.nearest_unbalanced_spin = [&load](double omega) { return load.nearest_unbalanced_spin(omega); };
  // A hand at the height of the centre of mass asks for no torque at rest: noise is not to choose a
  // direction.
  search.torque_noise = 1e-9 * motion.friction_at_rest() * motion.normal_force() * load.radius();
  if (const PhaseSampledLoad *phases = load.phases())
    if (const std::optional<double> near = spin_at_first_phase(*phases, motion, search))
      search.initial_guess = near;
  double asked = 0;
  if (question.with_slope || load.phases())
  {
    found.terminal = terminal_spin(torque, motion.yaw_inertia, search);
    asked = found.terminal->omega;
  }
  else
  {
    std::optional<SpinZero> zero;
    if (question.near)
      zero = find_terminal_spin_near(*question.near, torque, search);
    if (!zero)
      zero = find_terminal_spin(torque, search);
    found.terminal = { zero->omega, nan, nan, true, zero->held };
    asked = zero->asked;
  }
  found.zero_of_mean_torque = found.terminal->omega;
  if (load.phases())
    take_long_run_mean(load, question, search.spin_scale, found);
  return asked;
}

/// Fills @p found as far as it gets.
void find_spin(const LoadAtSpin &load, const Question &question, Answer &found)
{
  found.harmonics = load.n_harmonics();
  found.at_rest = ring_state(load.at(0), question, 0);
  Answer searched = found; // without a terminal spin unless all of it is found
  double asked = 0;
  try
  {
    asked = find_terminal(load, question, searched);
  }
  catch (const BalanceLost &lost)
  {
    if (!lost.tips())
      throw;
    found.status = Status::tips;
    found.fall = { lost.last_spin, ring_state(load.at(lost.last_spin), question, lost.last_spin) };
    found.reason = fall_sentence(*found.fall);
    return;
  }
  found = searched;
  found.at_terminal = ring_state(load.at(asked), question, asked);
  found.status = found.at_terminal->minimum < 0 ? Status::formal : Status::full_contact;
}

Question without_minima_of(const Question &question)
{
  Question asked = { question.motion, question.grip_torque, question.contact_radius };
  asked.with_minima = false;
  return asked;
}

/// Torques at the spins of the question; NaN without a balance, and the reason of @p found says why.
void find_torques(const LoadAtSpin &load, const Question &question, Answer &found)
{
  if (question.spins.empty())
    return;
  const Question without_minima = without_minima_of(question);
  std::string reason;
  found.torques.clear();
  for (const double omega : question.spins)
  {
    const auto find = [&]() -> Torques { return ring_state(load.at(omega), without_minima, omega); };
    found.torques.push_back(if_balanced(find, &reason).value_or(Torques{ { nan, nan, nan }, nan, nan }));
  }
  if (found.reason.empty())
    found.reason = reason;
}

/// Equal steps of the forward Euler method of at most @p longest [s] in each of @p n_intervals equal
/// intervals of a time of @p end [s].
unsigned int euler_steps(double end, unsigned int n_intervals, double longest)
{
  const double n_steps = std::ceil(end / n_intervals / longest - 1e-9);
  return std::max(static_cast<unsigned int>(n_steps), 1u);
}

/// Adds the spin-up to @p found.
void spin_up(const LoadAtSpin &load, const Question &question, Answer &found)
{
  const Motion &motion = question.motion;
  const std::vector<double> &times = question.times;
  // Steps of an integrator reach beyond a fall: from there on the torque stays.
  const double end = found.fall ? found.fall->omega : 0., limit = std::abs(end);
  const auto torque = [&, free = torque_function(load, question)](double time, double yaw_angle, double omega)
  {
    return free(time, yaw_angle,
                found.fall ? std::clamp(omega, std::min(0., end), std::max(0., end)) : omega);
  };
  const auto unless_fallen = [&](YawSample sample)
  {
    if (found.fall && std::abs(sample.omega) > limit)
      sample.omega = sample.yaw_angle = nan;
    return sample;
  };
  for (const YawSample &sample :
       yaw_motion(torque, motion.yaw_inertia, 0, times, spin_up_accuracy, load.spin_scale(motion)))
    found.spin_up.push_back(unless_fallen(sample));
  if (question.euler_step == 0)
    return;
  const auto n_intervals = static_cast<unsigned int>(times.size()) - 1;
  const unsigned int stride = euler_steps(times.back(), n_intervals, question.euler_step);
  const unsigned int n_steps = stride * n_intervals;
  const std::vector<YawSample> samples =
    yaw_motion_euler(torque, motion.yaw_inertia, 0, times.back() / n_steps, n_steps);
  for (unsigned int i = 0; i <= n_intervals; ++i)
    found.euler.push_back(unless_fallen(samples[i * stride]));
}
/// Adds the instants of the spin-up to @p found.
void add_instants(const LoadAtSpin &load, const Question &question, Answer &found)
{
  constexpr std::size_t n_intervals = 24;
  constexpr double near = 0.995;
  const std::vector<YawSample> &spin_up = found.spin_up;
  std::size_t n = 0; // samples before the glass tips
  while (n < spin_up.size() && std::isfinite(spin_up[n].omega))
    ++n;
  if (n == 0)
    return;
  std::size_t last = 0;
  while (last + 1 < n && std::abs(spin_up[last].omega) < near * std::abs(spin_up[n - 1].omega))
    ++last;
  const Question without_minima = without_minima_of(question);
  const std::size_t n_steps = std::min(n_intervals, last);
  for (std::size_t i = 0; i <= n_steps; ++i)
  {
    const YawSample &sample = spin_up[n_steps == 0 ? 0 : i * last / n_steps];
    found.instants.push_back({ sample, ring_state(load.at(sample.omega), without_minima, sample.omega) });
  }
}

std::vector<double> torques_by_phase(const PhaseSampledLoad &phases, const Motion &motion, double omega)
{
  std::vector<double> torques;
  for (const RingStack &load : phases.samples(omega))
    torques.push_back(wrench(motion, load, omega).torque);
  return torques;
}

void find_curves(const LoadAtSpin &load, const Question &question, Answer &found)
{
  if (question.all_spins)
    found.all_spins = all_terminal_spins(load, question, found);
  if (!question.times.empty())
    spin_up(load, question, found);
  if (!question.with_instants)
    return;
  add_instants(load, question, found);
  if (const PhaseSampledLoad *phases = load.phases(); phases && found.last_spin())
    found.phase_torques = { torques_by_phase(*phases, question.motion, 0),
                            torques_by_phase(*phases, question.motion, *found.last_spin()) };
}
} // namespace

std::string to_string(Status status)
{
  static constexpr const char *names[] = { "full contact", "lift-off",   "formal",
                                           "tips",         "no balance", "no terminal spin" };
  return names[static_cast<std::size_t>(status)];
}

RingState ring_state(const LeaningLoad &load, const Question &question, double omega)
{
  RingState state = { {}, load };
  state.friction = wrench(question.motion, load, omega);
  state.lean_torque = load.lean_torque();
  state.grip_torque = grip_torque(state.friction.torque + state.lean_torque, omega, question.grip_torque);
  state.moment_ratio = load.moment_ratio(question.contact_radius.value_or(load.radius()));
  if (question.with_minima)
  {
    state.minimum = load.minimum();
    state.pulling_share = state.minimum < 0 ? load.pulling_force() / load.normal_force() : 0;
  }
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

std::optional<ZeroGuess> Answer::zero_guess() const
{
  if (!terminal || terminal->held || !(terminal->torque_slope < 0) || terminal->omega == 0)
    return std::nullopt;
  return ZeroGuess{ terminal->omega, terminal->torque_slope };
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

Answer answer(const LoadAtSpin &load, const Question &question)
{
  Answer found = question.known ? *question.known : Answer();
  const auto complete = [&](const auto &find)
  {
    try
    {
      find(load, question, found);
      return true;
    }
    catch (const NoBalance &)
    {
      found = failed_answer(std::current_exception(), std::move(found));
      return false;
    }
  };
  const bool is_found = question.known || complete(find_spin);
  find_torques(load, question, found);
  if (is_found)
    complete(find_curves);
  return found;
}

SharedLoad interpolated_for_curves(const SharedLoad &load, const Answer &found, double lower, double upper,
                                   const LoadAtSpin *like)
{
  const auto between = [&](double one, double other, double enough = 2e-5)
  {
    return if_balanced(
             [&] { return interpolated(load, std::min(one, other), std::max(one, other), enough, like); })
      .value_or(nullptr);
  };
  if (found.fall) // steep where the balance ends
  {
    const SharedLoad curve = between(0, found.fall->omega, 1e-3);
    return curve ? curve : load;
  }
  if (const SharedLoad curve = between(lower, upper))
    return curve;
  const double terminal = found.omega_terminal().value_or(0), margin = 0.02 * std::abs(terminal);
  const SharedLoad curve = between(std::min(0., terminal - margin), std::max(0., terminal + margin));
  return curve ? curve : load;
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

Answer compared_with_all(Answer answer, const Answer &all, const LoadAtSpin &load, const Motion &motion)
{
  if (!all.terminal)
    return answer;
  const double omega = all.terminal->omega;
  // Without a moment the glass does not spin up; rounding makes that a tiny spin, to which nothing can be
  // related.
  const double scale = motion.orbit_speed / all.at_rest->load.radius();
  if (answer.terminal && std::abs(omega) > 1e-9 * scale)
    answer.relative_change = (answer.terminal->omega - omega) / omega + 0.; // no -0
  answer.bound = truncation_bound(motion, all.at_terminal->load, answer.harmonics, omega);
  if (load.phases() && answer.at_rest)
  {
    for (const RingStack &sample : load.phases()->samples(omega))
      answer.bound = std::max(*answer.bound, truncation_bound(motion, sample, answer.harmonics, omega));
    for (const RingStack &sample : load.phases()->samples(0))
      answer.at_rest->minimum =
        std::min(answer.at_rest->minimum, sample.truncated(answer.harmonics).minimum());
  }
  return answer;
}

bool are_negligible_above(unsigned int n_harmonics, const Answer &all, const Motion &motion)
{
  constexpr double negligible = 1e-12; // of the terminal spin
  const std::optional<ZeroGuess> zero = all.zero_guess();
  return zero && truncation_bound(motion, all.at_terminal->load, n_harmonics, zero->omega) <
                   negligible * std::abs(zero->slope * zero->omega);
}

double yaw_torque(const LoadAtSpin &load, const Motion &motion, double omega,
                  const std::optional<Orientation> &marks)
{
  const LeaningLoad at_spin = load.at(omega, marks);
  return wrench(motion, at_spin, omega).torque + at_spin.lean_torque();
}

double grip_torque(double torque, double omega, double grip)
{
  if (omega == 0)
    return -std::copysign(std::min(std::abs(torque), grip), torque);
  return -std::copysign(grip, omega);
}

double torque_with_grip(double torque, double omega, double grip)
{
  return torque + grip_torque(torque, omega, grip);
}

std::vector<double> output_times(double end)
{
  constexpr unsigned int n_intervals = 200;
  std::vector<double> times;
  for (unsigned int i = 0; i <= n_intervals; ++i)
    times.push_back(end * i / n_intervals);
  return times;
}
} // namespace stemware::ring
