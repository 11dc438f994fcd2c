#include "ring_model/hand_drive.h"

#include "ring_model/first_harmonic_ring.h"
#include "ring_model/self_consistent_ring.h"

#include <cmath>
#include <memory>
#include <utility>

namespace stemware::ring
{
PhasedTorqueFunction driven_torque(Closure closure, const Motion &motion, double radius,
                                   OrbitSpeedTable speeds)
{
  if (!motion.has_constant_friction())
  {
    const auto model = std::make_shared<const FirstHarmonicModel>(radius);
    SelfConsistentRing(closure, motion, model); // refuses what is not allowed before the first step
    return [closure, motion, model, speeds = std::move(speeds)](double time, double, double omega)
    { return SelfConsistentRing(closure, speeds.motion_at(motion, time), model).torque(omega); };
  }
  FirstHarmonicRing(closure, motion, radius); // likewise
  return [closure, motion, radius, speeds = std::move(speeds)](double time, double, double omega)
  { return FirstHarmonicRing(closure, speeds.motion_at(motion, time), radius).torque(omega); };
}

std::vector<YawSample> driven_motion(const PhasedTorqueFunction &torque, const OrbitSpeedTable &speeds,
                                     double yaw_inertia, const std::vector<double> &times, double accuracy,
                                     double spin_scale)
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
  for (YawSample sample : yaw_motion(torque_since, yaw_inertia, 0., later, accuracy, spin_scale))
  {
    sample.time += start;
    samples.push_back(sample);
  }
  return samples;
}
} // namespace stemware::ring
