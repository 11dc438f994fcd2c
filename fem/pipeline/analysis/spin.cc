#include "fem/pipeline/analysis/spin.h"

#include "fem/contact/contact_solution.h"
#include "fem/pipeline/coupling/if_balanced.h"
#include "fem/pipeline/coupling/phase_loads.h"
#include "fem/pipeline/coupling/phases.h"
#include "fem/pipeline/support/numbers.h"
#include "fem/pipeline/variants/solve.h"
#include "ring_model/friction_law.h"

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>

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

/// Where the load of rest would take the glass: a first guess. Nothing if it takes the glass nowhere.
std::optional<double> expected_spin(const BalancedLoad &load, const ring::Motion &motion)
{
  try
  {
    return ring::terminal_spin(load.at(0), motion).omega;
  }
  catch (const ring::NoBalance &)
  {
    return std::nullopt;
  }
}

std::string fall_sentence(const Fall &fall)
{
  return "the glass stands at rest and falls over on the way, at " +
         to_short_text(rounded(fall.omega + 0., 3)) + " rad/s and a moment ratio of " +
         to_short_text(rounded(fall.state.moment_ratio, 3));
}

/// Fills the row as far as it gets.
void solve_row(const BalancedLoad &load, const SpinQuestion &question, SpinRow &row)
{
  row.harmonics = load.n_harmonics();
  row.at_rest = ring_state(load, question, 0);
  LongRunSpin found;
  try
  {
    found = terminal_spin(load, question.motion, question.expected, question.with_slope, question.grip_torque,
                          question.near);
  }
  catch (const ring::BalanceLost &lost)
  {
    const auto *beyond = dynamic_cast<const std::nested_exception *>(&lost);
    if (!beyond || failed_row(beyond->nested_ptr()).standing != Standing::tips)
      throw;
    row.standing = Standing::tips;
    row.fall = { lost.last_spin, ring_state(load, question, lost.last_spin) };
    row.reason = fall_sentence(*row.fall);
    return;
  }
  row.terminal = found.spin;
  row.ripple = found.ripple;
  row.spin_uncertainty = found.uncertainty;
  row.zero_of_mean_torque = found.zero_of_mean_torque;
  row.at_terminal = ring_state(load, question, found.asked);
  row.standing = row.at_terminal->minimum < 0 ? Standing::formal : Standing::full_contact;
}

} // namespace

RingState ring_state(const BalancedLoad &load, const SpinQuestion &question, double omega)
{
  const LeaningLoad leaning = load.at(omega);
  RingState state = { leaning };
  const ring::Motion &motion = question.motion;
  state.friction = ring::wrench(motion, state.load, omega);
  state.lean_torque = leaning.lean_torque();
  state.grip_torque = grip_torque(state.friction.torque + state.lean_torque, omega, question.grip_torque);
  state.moment_ratio = state.load.moment_ratio(question.contact_radius.value_or(state.load.radius()));
  if (question.with_minima)
  {
    state.minimum = state.load.minimum();
    state.pulling_share = state.minimum < 0 ? state.load.pulling_force() / state.load.normal_force() : 0;
  }
  return state;
}

double yaw_torque(const BalancedLoad &load, const ring::Motion &motion, double omega)
{
  const LeaningLoad at_spin = load.at(omega);
  return ring::wrench(motion, at_spin, omega).torque + at_spin.lean_torque();
}

ring::PhasedTorqueFunction torque_function(const BalancedLoad &load, const ring::Motion &motion,
                                           double grip_torque)
{
  return [load = load.shared_from_this(), motion, grip_torque](double time, double yaw_angle, double omega)
  {
    const LeaningLoad at_phase = load->at(omega, orientation_of_marks(motion, time, yaw_angle));
    const double torque = ring::wrench(motion, at_phase, omega).torque + at_phase.lean_torque();
    return grip_torque > 0 ? against_grip(torque, omega, grip_torque) : torque;
  };
}

ring::Wrench wrench(const BalancedLoad &load, const ring::Motion &motion, double omega)
{
  return ring::wrench(motion, load.at(omega), omega);
}

std::vector<double> friction_torques(const BalancedLoad &load, const ring::Motion &motion,
                                     const std::vector<double> &omega, std::string &reason)
{
  std::vector<double> torques;
  for (const double spin : omega)
    torques.push_back(if_balanced([&] { return wrench(load, motion, spin).torque; }, &reason)
                        .value_or(std::numeric_limits<double>::quiet_NaN()));
  return torques;
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
  search.steadiness = [&load](double omega) { return load.steadiness(omega); };
  search.fall_before = [&load](double omega) { return load.fall_before(omega); };
  // A hand at the height of the centre of mass asks for no torque at rest: noise is not to choose a
  // direction.
  search.torque_noise =
    1e-9 * motion.friction_at_rest() * motion.normal_force() * load.report().rings.radius();
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  LongRunSpin result;
  if (with_slope || load.phases())
  {
    result.spin = ring::terminal_spin(torque, motion.yaw_inertia, search);
    result.asked = result.spin.omega;
  }
  else
  {
    std::optional<ring::SpinZero> nearby;
    if (near)
      nearby = ring::find_terminal_spin_near(*near, torque, search);
    const ring::SpinZero zero = nearby ? *nearby : ring::find_terminal_spin(torque, search);
    result.spin = { zero.omega, nan, nan, true, zero.held };
    result.asked = zero.asked;
  }
  result.zero_of_mean_torque = result.spin.omega;
  if (!load.phases())
    return result;
  // Of the mean in the long run; finer than the loads are known would be in vain.
  const PhaseLoads &phases = *load.phases();
  constexpr double coarsest = 1e-3; // where the loads between phases are known badly, their mean is not
  const double accuracy =
    std::clamp(0.1 * phases.error().between, 1e-9, std::max(coarsest, phases.error().mean));
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
  const double torque_error = (phases.error().mean + longer * phases.error().between) *
                              motion.friction_coefficient * motion.normal_force() *
                              load.report().rings.radius();
  result.uncertainty = mean.uncertainty;
  if (!result.spin.held)
    result.uncertainty += torque_error / std::abs(result.spin.torque_slope);
  return result;
}

double grip_torque(double torque, double omega, double grip)
{
  if (omega == 0)
    return -std::copysign(std::min(std::abs(torque), grip), torque);
  return -std::copysign(grip, omega);
}

double against_grip(double torque, double omega, double grip)
{
  return torque + grip_torque(torque, omega, grip);
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
    return row;
  }
  catch (const std::exception &failure)
  {
    if (!is_of_variant(failure))
      throw;
    return failed_row(std::current_exception(), row);
  }
}

SpinRow failed_row(const std::exception_ptr &failure, SpinRow row)
{
  try
  {
    std::rethrow_exception(failure);
  }
  catch (const std::exception &why)
  {
    const auto *contact = dynamic_cast<const fem::ContactFailure *>(&why);
    row.standing = Standing::no_balance;
    if (dynamic_cast<const ring::Tipping *>(&why) ||
        (contact && contact->outcome == fem::ContactOutcome::tipping))
      row.standing = Standing::tips;
    if (dynamic_cast<const ring::NoTerminalSpin *>(&why))
      row.standing = Standing::no_terminal_spin;
    row.reason = why.what();
  }
  return row;
}

std::vector<double> output_times(double end)
{
  constexpr unsigned int n_intervals = 200;
  std::vector<double> times;
  for (unsigned int i = 0; i <= n_intervals; ++i)
    times.push_back(end * i / n_intervals);
  return times;
}

std::vector<ring::YawSample> spin_up(const ring::PhasedTorqueFunction &torque, const ring::Motion &motion,
                                     const std::vector<double> &times, double spin_scale)
{
  return ring::yaw_motion(torque, motion.yaw_inertia, 0, times, spin_up_accuracy, spin_scale);
}

std::vector<ring::YawSample> spin_up(const BalancedLoad &load, const ring::Motion &motion,
                                     const std::vector<double> &times, double grip_torque)
{
  return spin_up(torque_function(load, motion, grip_torque), motion, times, load.spin_scale(motion));
}

std::vector<RimSlip> rim_slip(const ring::Motion &motion, double radius, const ring::RingStack &load,
                              double omega)
{
  constexpr unsigned int n_places = 24;
  const double mean = motion.friction_at_rest() * load.a(0);
  std::vector<RimSlip> places;
  for (unsigned int i = 0; i < n_places; ++i)
  {
    const double theta = boost::math::double_constants::two_pi * i / n_places;
    const double slip_x = motion.orbit_speed - omega * radius * std::sin(theta),
                 slip_y = omega * radius * std::cos(theta), slip = std::hypot(slip_x, slip_y);
    const double share = slip > 0 ? -motion.friction_at(slip) * std::max(0., load(theta)) / (mean * slip) : 0;
    places.push_back(
      { theta, slip_x / motion.orbit_speed, slip_y / motion.orbit_speed, share * slip_x, share * slip_y });
  }
  return places;
}

} // namespace stemware::pipeline
