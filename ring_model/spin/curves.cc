#include "ring_model/spin/curves.h"

#include "ring_model/friction_functionals.h"
#include "ring_model/if_balanced.h"
#include "ring_model/spin/phase_loads.h"
#include "ring_model/yaw_motion.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace stemware::ring
{
namespace
{
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr double spin_up_accuracy = 1e-10; ///< of omega(t), relative to v / R

/// Friction and lean torque together [N m]; time and yaw angle matter if the phase does.
PhasedTorqueFunction torque_function(const LoadAtSpin &load, const Question &question)
{
  const auto torque = [&](double time, double yaw_angle, double omega)
  {
    const Motion &motion = question.motion;
    return yaw_torque(load, motion, omega, orientation_of_marks(motion, time, yaw_angle));
  };
  return observed(torque, question.observer);
}

Question without_minima_of(const Question &question)
{
  Question asked = { question.motion, question.grip_torque, question.contact_radius };
  asked.with_minima = false;
  return asked;
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
      sample.omega = sample.yaw_angle = unknown;
    return sample;
  };
  for (const YawSample &sample : yaw_motion(torque, motion.yaw_inertia, 0, times, spin_up_accuracy,
                                            load.spin_scale(motion), question.grip_torque))
    found.spin_up.push_back(unless_fallen(sample));
  if (question.euler_step == 0)
    return;
  const auto n_intervals = static_cast<unsigned int>(times.size()) - 1;
  const unsigned int stride = euler_steps(times.back(), n_intervals, question.euler_step);
  const unsigned int n_steps = stride * n_intervals;
  const std::vector<YawSample> samples =
    yaw_motion_euler(torque, motion.yaw_inertia, 0, times.back() / n_steps, n_steps, question.grip_torque);
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

} // namespace

void add_torques(const LoadAtSpin &load, const Question &question, Answer &found)
{
  if (question.spins.empty() && question.terminal_shares.empty())
    return;
  const Question without_minima = without_minima_of(question);
  std::string reason;
  const auto torques_at = [&](double omega)
  {
    const auto find = [&]() -> Torques { return ring_state(load.at(omega), without_minima, omega); };
    return if_balanced(find, &reason).value_or(Torques{ { unknown, unknown, unknown }, unknown, unknown });
  };
  found.torque_spins = question.spins;
  found.torques.clear();
  for (const double omega : question.spins)
    found.torques.push_back(torques_at(omega));
  for (const double share : question.terminal_shares)
    if (found.terminal || share == 0)
    {
      found.torque_spins.push_back(share * found.omega_terminal().value_or(0) + 0.); // no -0
      // With phases the terminal spin is a mean, at which the torques do not vanish.
      found.torques.push_back(share == 1 ? *found.at_terminal : torques_at(found.torque_spins.back()));
    }
  if (found.reason.empty())
    found.reason = reason;
}

void add_curves(const LoadAtSpin &load, const Question &question, Answer &found)
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

std::vector<double> output_times(double end)
{
  constexpr unsigned int n_intervals = 200;
  std::vector<double> times;
  for (unsigned int i = 0; i <= n_intervals; ++i)
    times.push_back(end * i / n_intervals);
  return times;
}
} // namespace stemware::ring
