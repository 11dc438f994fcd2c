#include "ring_model/spin/hand_drive.h"

#include "ring_model/self_consistent_ring.h"
#include "ring_model/spin/answer.h"

#include <cmath>
#include <cstddef>
#include <utility>

namespace stemware::ring
{
PhasedTorqueFunction driven_torque(Closure closure, const Motion &motion, double radius,
                                   OrbitSpeedTable speeds)
{
  SelfConsistentRing(closure, motion, radius); // throws for invalid parameters before the first step
  return [closure, motion, radius, speeds = std::move(speeds)](double time, double, double omega)
  { return SelfConsistentRing(closure, speeds.motion_at(motion, time), radius).torque(omega); };
}

PhasedTorqueFunction driven_torque(const Motion &motion, OrbitSpeedTable speeds, DrivenLoad load)
{
  return [motion, speeds = std::move(speeds), load = std::move(load)](double time, double, double omega)
  {
    const Motion now = speeds.motion_at(motion, time);
    return yaw_torque(load(now, time, omega), now, omega);
  };
}

std::vector<YawSample> driven_motion(const PhasedTorqueFunction &torque, const OrbitSpeedTable &speeds,
                                     const Motion &motion, double grip, double radius,
                                     const std::vector<double> &times, double accuracy)
{
  const double start =
    speeds.starts_from_rest() ? speeds.time_of(std::cbrt(accuracy / 10.) * speeds.max_speed()) : 0.;
  std::vector<YawSample> samples;
  std::vector<double> later;
  for (const double time : times)
    if (time < start)
      samples.push_back({ time, 0., 0. });
    else
      later.push_back(time - start);
  const auto torque_since = [&](double time, double angle, double omega)
  { return torque(start + time, angle, omega); };
  std::vector<double> breaks = speeds.knots();
  for (double &time : breaks)
    time -= start;
  for (YawSample sample : yaw_motion(torque_since, motion.yaw_inertia, 0., later, accuracy,
                                     motion.orbit_speed / radius, grip, breaks))
  {
    sample.time += start;
    samples.push_back(sample);
  }
  return samples;
}

std::vector<double> interpolation_changes(Closure closure, const Motion &motion, double grip, double radius,
                                          const OrbitSpeedTable &speeds, const std::vector<double> &times)
{
  constexpr double accuracy = 1e-7; // limited by jumps of the acceleration of the piecewise linear speed
  const auto motion_of = [&](const OrbitSpeedTable &table)
  {
    return driven_motion(driven_torque(closure, motion, radius, table), table, motion, grip, radius, times,
                         accuracy);
  };
  const std::vector<YawSample> cubic = motion_of(speeds), lines = motion_of(speeds.joined_by_lines());
  std::vector<double> changes;
  for (std::size_t i = 0; i < times.size(); ++i)
    changes.push_back(std::abs(lines[i].omega - cubic[i].omega));
  return changes;
}

Breakaway find_breakaway(Closure closure, const Motion &motion, double static_friction, double radius,
                         const OrbitSpeedTable &speeds)
{
  const double start = speeds.time_of(0);
  Motion at_start = speeds.motion_at(motion, start);
  at_start.orbit_acceleration = 0;
  at_start.friction_coefficient =
    at_start.has_constant_friction() && static_friction > 0 ? static_friction : at_start.friction_at(0);
  at_start.friction_law = FrictionLawKind::coulomb;
  const double moment = required_moment_at_rest(closure, at_start).norm();
  return { start, at_start, at_start.friction_coefficient * at_start.normal_force(),
           2 * moment / (at_start.normal_force() * radius) };
}
} // namespace stemware::ring
