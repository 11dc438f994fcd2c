#include "fem/pipeline/analysis/spin.h"

#include "fem/contact/contact_newton.h"
#include "fem/pipeline/coupling/orientation.h"
#include "fem/pipeline/coupling/phase_loads.h"
#include "ring_model/friction_law.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace stemware::pipeline
{

namespace
{

constexpr double spin_up_accuracy = 1e-10; ///< of omega(t), relative to v / R

/// Time over which the mean spin is taken: a good dozen of the slowest repetition of the phase, which in a
/// glass that nearly follows its orbit may take for ever, and of the time in which the spin forgets its
/// start.
double averaging_window(const PhasePeriods &periods, const ring::Motion &motion,
                        const ring::TerminalSpin &terminal)
{
  const double orbit = std::abs(motion.orbit_rate());
  double slowest = periods.table / orbit;
  if (periods.glass > 0)
    slowest = std::max(slowest,
                       periods.glass / std::max(std::abs(terminal.omega - motion.orbit_rate()), 0.1 * orbit));
  return std::max(16 * slowest, 8 * std::min(terminal.time_constant, 100 / orbit));
}

RingState ring_state(const BalancedLoad &load, const SpinQuestion &question, double omega)
{
  RingState state = { load.at(omega) };
  const ring::Motion &motion = question.motion;
  state.friction = ring::wrench(motion, state.load, omega);
  state.moment_ratio = state.load.moment_ratio();
  if (question.with_minima)
  {
    state.minimum = state.load.minimum();
    state.pulling_share = state.minimum < 0 ? state.load.pulling_force() / state.load.normal_force() : 0;
  }
  return state;
}

/// tau_z, or NaN with a reason where the load has no balance.
double torque_or_nan(const BalancedLoad &load, const ring::Motion &motion, double omega, std::string &reason)
{
  try
  {
    return wrench(load, motion, omega).torque;
  }
  catch (const std::runtime_error &failure)
  {
    reason = failure.what();
    return std::numeric_limits<double>::quiet_NaN();
  }
}

/// The load between rest and @p terminal, and a little beyond.
BalancedLoad on_the_way_to(double terminal, const BalancedLoad &load)
{
  const double margin = 0.02 * std::abs(terminal);
  return load.interpolated(std::min(0., terminal - margin), std::max(0., terminal + margin));
}

/// Where the load of rest would take the glass: a first guess. Nothing where that is nowhere.
std::optional<double> expected_spin(const BalancedLoad &load, const ring::Motion &motion)
{
  try
  {
    return ring::terminal_spin(load.at_rest(), motion).omega;
  }
  catch (const ring::NoTerminalSpin &)
  {
    return std::nullopt;
  }
}

/// Fills the row as far as it gets. @p searching says whether the load itself had an answer everywhere.
void solve_row(const BalancedLoad &load, const SpinQuestion &question, SpinRow &row)
{
  row.harmonics = load.n_harmonics();
  row.all_harmonics = row.harmonics == load.report().rings.n_harmonics();
  row.at_rest = ring_state(load, question, 0);
  for (const double omega : question.torques_at)
    row.torques.push_back(torque_or_nan(load, question.motion, omega, row.reason));
  const LongRunSpin found = terminal_spin(load, question.motion, question.expected, question.with_slope,
                                          question.grip_torque, question.near);
  const double omega = found.spin.omega;
  row.terminal = found.spin;
  row.ripple = found.ripple;
  row.spin_uncertainty = found.uncertainty;
  row.zero_of_mean_torque = found.zero_of_mean_torque;
  row.at_terminal = ring_state(load, question, omega);
  row.standing = row.at_terminal->minimum < 0 ? Standing::formal : Standing::full_contact;
  if (!question.times.empty())
    for (const ring::YawSample &sample :
         spin_up(question.on_the_way ? *question.on_the_way : on_the_way_to(omega, load), question.motion,
                 question.times, question.grip_torque))
      row.spin_up.push_back(sample.omega);
}

} // namespace

double yaw_torque(const BalancedLoad &load, const ring::Motion &motion, double omega)
{
  const LeaningLoad at_spin = load.leaning(omega);
  return ring::wrench(motion, at_spin.rings, omega).torque + at_spin.lean_torque();
}

ring::PhasedTorqueFunction torque_function(const BalancedLoad &load, const ring::Motion &motion,
                                           double grip_torque)
{
  return [=](double time, double yaw_angle, double omega)
  {
    const LeaningLoad at_phase = load.leaning(omega, orientation_of_marks(motion, time, yaw_angle));
    const double torque = ring::wrench(motion, at_phase.rings, omega).torque + at_phase.lean_torque();
    return grip_torque > 0 ? against_grip(torque, omega, grip_torque) : torque;
  };
}

ring::Wrench wrench(const BalancedLoad &load, const ring::Motion &motion, double omega)
{
  return ring::wrench(motion, load.at(omega), omega);
}

LongRunSpin terminal_spin(const BalancedLoad &load, const ring::Motion &motion, double expected,
                          bool with_slope, double grip_torque, const std::optional<ring::KnownZero> &near)
{
  const auto torque = [&](double omega) { return yaw_torque(load, motion, omega); };
  ring::SpinSearch search;
  search.spin_scale = load.spin_scale(motion);
  search.tolerance = 1e-11; // contacts are good to 1e-10 of the load or better
  search.expected = expected != 0 ? expected : expected_spin(load, motion);
  search.grip_torque = grip_torque;
  // A hand at the height of the centre of mass asks for no torque at rest: noise is not to choose a
  // direction.
  search.torque_noise =
    1e-9 * motion.friction_at_rest() * motion.normal_force() * load.report().rings.radius();
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  LongRunSpin result;
  if (with_slope || load.phases())
    result.spin = ring::terminal_spin(torque, motion.yaw_inertia, search);
  else
  {
    std::optional<ring::SpinZero> nearby;
    if (near)
      nearby = ring::find_terminal_spin_near(*near, torque, search);
    const ring::SpinZero zero = nearby ? *nearby : ring::find_terminal_spin(torque, search);
    result.spin = { zero.omega, nan, nan, true, zero.held };
  }
  result.zero_of_mean_torque = result.spin.omega;
  if (!load.phases())
    return result;
  // Of the mean in the long run; finer than the loads are known would be in vain.
  const PhaseLoads &phases = *load.phases();
  constexpr double coarsest = 1e-3; // where the loads between phases are known badly, their mean is not
  const double accuracy = std::clamp(0.1 * phases.error(), 1e-9, std::max(coarsest, phases.mean_error()));
  const ring::LongTimeSpin mean = ring::long_time_spin(
    torque_function(load, motion, grip_torque), motion.yaw_inertia, result.spin.omega,
    averaging_window(load.phases()->periods(), motion, result.spin), accuracy, search.spin_scale);
  result.spin.omega = mean.mean;
  result.ripple = mean.ripple;
  // The mean's own error, and that between phases as far as ripple makes the glass stay longer at some.
  const double turning = std::abs(mean.mean - motion.orbit_rate());
  const double longer = phases.phases().glass.size() == 1 ? 0
                        : mean.ripple < turning           ? mean.ripple / turning
                                                          : 1;
  const double torque_error = (phases.mean_error() + longer * phases.error()) * motion.friction_coefficient *
                              motion.normal_force() * load.report().rings.radius();
  result.uncertainty = mean.uncertainty;
  if (!result.spin.held)
    result.uncertainty += torque_error / std::abs(result.spin.torque_slope);
  return result;
}

double against_grip(double torque, double omega, double grip)
{
  if (omega == 0)
    return std::abs(torque) <= grip ? 0 : torque - std::copysign(grip, torque);
  return torque - std::copysign(grip, omega);
}

SpinRow spin_row(const BalancedLoad &load, const SpinQuestion &question)
{
  SpinRow row;
  solve_row(load, question, row);
  return row;
}

SpinRow attempt_spin_row(const BalancedLoad &load, const SpinQuestion &question)
{
  SpinRow row;
  try
  {
    solve_row(load, question, row);
  }
  catch (const ring::NoTerminalSpin &failure)
  {
    row.standing = Standing::no_terminal_spin;
    row.reason = failure.what();
  }
  catch (const std::exception &failure)
  {
    row.standing = standing_of_failure();
    row.reason = failure.what();
  }
  return row;
}

Standing standing_of_failure()
{
  try
  {
    throw;
  }
  catch (const ring::Tipping &)
  {
    return Standing::tips;
  }
  catch (const fem::ContactFailure &failure)
  {
    return failure.outcome == fem::ContactOutcome::tipping ? Standing::tips : Standing::no_balance;
  }
  catch (const std::exception &)
  {
    return Standing::no_balance;
  }
}

void relate_to_all(const SpinRow &all, const ring::RingStack &whole, const SpinQuestion &question,
                   SpinRow &row)
{
  const ring::Motion &motion = question.motion;
  const double omega = all.terminal->omega;
  // Without a moment the glass does not spin up; rounding makes that a tiny spin, to which nothing can be
  // related.
  const double scale = motion.orbit_speed / all.at_rest->load.radius();
  if (row.terminal && std::abs(omega) > 1e-9 * scale)
    row.relative_change = (row.terminal->omega - omega) / omega + 0.; // no -0
  row.bound = ring::truncation_bound(motion, whole, row.harmonics, omega);
  if (row.spin_up.empty() || all.spin_up.empty())
    return;
  double largest = 0;
  for (std::size_t i = 0; i < row.spin_up.size(); ++i)
    largest = std::max(largest, std::abs(row.spin_up[i] - all.spin_up[i]));
  row.largest_deviation = largest;
  row.final_deviation = std::abs(row.spin_up.back() - all.spin_up.back());
}

std::vector<unsigned int> truncation_orders(unsigned int n_all)
{
  std::vector<unsigned int> orders;
  for (const unsigned int n : { 1u, 2u, 3u })
    if (n < n_all)
      orders.push_back(n);
  for (unsigned int octave = 4; octave < n_all; octave *= 2)
    for (const unsigned int n : { octave, octave + octave / 2 })
      if (n < n_all)
        orders.push_back(n);
  orders.push_back(n_all);
  return orders;
}

std::vector<double> output_times(double end)
{
  constexpr unsigned int n_intervals = 200;
  std::vector<double> times;
  for (unsigned int i = 0; i <= n_intervals; ++i)
    times.push_back(end * i / n_intervals);
  return times;
}

std::vector<ring::YawSample> spin_up(const BalancedLoad &load, const ring::Motion &motion,
                                     const std::vector<double> &times, double grip_torque)
{
  return ring::yaw_motion(torque_function(load, motion, grip_torque), motion.yaw_inertia, 0, times,
                          spin_up_accuracy, load.spin_scale(motion));
}

} // namespace stemware::pipeline
