#include "ring_model/hand_drive.h"

#include "ring_model/first_harmonic_ring.h"
#include "ring_model/self_consistent_ring.h"

#include <utility>

namespace stemware::ring
{
TimedTorqueFunction driven_torque(Closure closure, const Motion &motion, double radius,
                                  OrbitSpeedTable speeds)
{
  FirstHarmonicRing(closure, motion, radius); // refuses what is not allowed before the first step
  return [closure, motion, radius, speeds = std::move(speeds)](double time, double omega)
  { return FirstHarmonicRing(closure, speeds.motion_at(motion, time), radius).torque(omega); };
}

TimedTorqueFunction driven_torque(Closure closure, const Motion &motion,
                                  std::shared_ptr<const LoadModel> model, OrbitSpeedTable speeds)
{
  const SelfConsistentRing first(closure, motion, model); // refuses what is not allowed before the first step
  return [closure, motion, model = std::move(model), speeds = std::move(speeds)](double time, double omega)
  { return SelfConsistentRing(closure, speeds.motion_at(motion, time), model).torque(omega); };
}
} // namespace stemware::ring
