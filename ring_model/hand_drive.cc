#include "ring_model/hand_drive.h"

#include "ring_model/first_harmonic_ring.h"

#include <utility>

namespace stemware::ring
{
PhasedTorqueFunction driven_torque(Closure closure, const Motion &motion, double radius,
                                   OrbitSpeedTable speeds)
{
  FirstHarmonicRing(closure, motion, radius); // refuses what is not allowed before the first step
  return [closure, motion, radius, speeds = std::move(speeds)](double time, double, double omega)
  { return FirstHarmonicRing(closure, speeds.motion_at(motion, time), radius).torque(omega); };
}
} // namespace stemware::ring
