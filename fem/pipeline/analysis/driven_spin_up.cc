#include "fem/pipeline/analysis/spin_study.h"
#include "fem/pipeline/base/failures.h"
#include "fem/pipeline/base/numbers.h"
#include "fem/pipeline/base/text.h"
#include "fem/pipeline/coupling/study_load.h"
#include "ring_model/failures.h"

#include <algorithm>

namespace stemware::pipeline
{

namespace
{

/// Returns the result of @p solve. Throws BadInput with @p sentence if the glass tips.
template <typename Solve>
auto unless_it_tips(const Solve &solve, const std::string &sentence)
{
  try
  {
    return solve();
  }
  catch (const ring::Tipping &)
  {
    throw BadInput(sentence);
  }
}

/// Returns tau_z(t, psi, omega) [N m] without the grip, independent of the yaw angle psi.
ring::PhasedTorqueFunction driven_torque(const MotionSection &motion, double contact_radius,
                                         const std::shared_ptr<ElasticFoot> &foot)
{
  const ring::OrbitSpeedTable &speeds = *motion.orbit_speeds;
  if (!foot)
    return ring::driven_torque(motion.closure, motion.orbit, contact_radius, speeds);
  const ring::DrivenLoad load =
    [foot, of_study = moment_balance(foot->specification().study),
     file = motion.orbit_speed_file](const ring::Motion &now, double time, double omega)
  {
    ContactBalance balance = of_study;
    balance.motion = now;
    const auto solve = [&]
    {
      BalancedContact contacts(foot, balance);
      return contacts.sample_of(contacts.contact(omega));
    };
    return unless_it_tips(
      solve, filled("Motion/Orbit speed file = {}: at t = {} s, where v = {} m/s and dv/dt = {} m/s^2, the "
                    "glass tips; give lower speeds, or more rows where the speed changes.",
                    { shortened_path(file), to_short_text(time), to_short_text(now.orbit_speed),
                      to_short_text(now.orbit_acceleration) }));
  };
  return ring::driven_torque(motion.orbit, speeds, load);
}

/// Returns the breakaway of a hand that starts from rest, with Motion/Breakaway friction or the law's
/// coefficient at rest. Throws BadInput if the glass tips before it slides.
ring::Breakaway find_breakaway(const MotionSection &motion, double contact_radius,
                               const std::shared_ptr<ElasticFoot> &foot)
{
  ring::Breakaway breakaway = ring::find_breakaway(motion.closure, motion.orbit, motion.breakaway_friction,
                                                   contact_radius, *motion.orbit_speeds);
  const std::string tipping_message =
    filled("Motion/Orbit speed file = {}: the glass tips at t = {} s, before the hand's force reaches "
           "the {} N at which it slides; hold the glass lower, or reduce the friction.",
           { shortened_path(motion.orbit_speed_file), to_short_text(breakaway.time),
             to_short_text(breakaway.force) });
  if (!foot)
  {
    ensure(breakaway.moment_ratio < 2, tipping_message);
    return breakaway;
  }
  ContactBalance balance = moment_balance(foot->specification().study);
  balance.motion = breakaway.motion;
  const auto solve = [&] { return BalancedContact(foot, balance).contact(0).load.moment().norm(); };
  breakaway.moment_ratio =
    2 * unless_it_tips(solve, tipping_message) / (balance.motion.normal_force() * contact_radius);
  return breakaway;
}

} // namespace

std::optional<DrivenSpinUp> driven_spin_up(const MotionSection &motion, double contact_radius,
                                           const std::shared_ptr<ElasticFoot> &foot,
                                           const std::vector<double> &times,
                                           const ring::TimeObserver &observer)
{
  if (!motion.orbit_speeds)
    return std::nullopt;
  const ring::OrbitSpeedTable &speeds = *motion.orbit_speeds;
  DrivenSpinUp driven;
  if (speeds.starts_from_rest())
    driven.breakaway = find_breakaway(motion, contact_radius, foot);
  // A step takes about a dozen contact solves, and measured speeds are less accurate than 1e-6.
  const double accuracy = foot ? 1e-6 : 1e-10;
  const ring::PhasedTorqueFunction torque =
    ring::observed(driven_torque(motion, contact_radius, foot), observer);
  const std::vector<ring::YawSample> samples =
    ring::driven_motion(torque, speeds, motion.orbit, motion.grip_torque, contact_radius, times, accuracy);
  const std::vector<double> changes = ring::interpolation_changes(
    motion.closure, motion.orbit, motion.grip_torque, contact_radius, speeds, times);
  driven.time = times;
  for (const double time : times)
  {
    driven.speed.push_back(speeds.speed(time));
    driven.acceleration.push_back(speeds.acceleration(time));
  }
  for (const ring::YawSample &sample : samples)
    driven.omega.push_back(sample.omega);
  driven.integration_error = accuracy * motion.orbit.orbit_speed / contact_radius;
  driven.interpolation_change_at_end = changes.back();
  driven.interpolation_change = *std::max_element(changes.begin(), changes.end());
  return driven;
}

} // namespace stemware::pipeline
