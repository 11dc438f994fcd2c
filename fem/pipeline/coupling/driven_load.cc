#include "fem/pipeline/coupling/driven_load.h"

#include "fem/pipeline/coupling/balanced_contact.h"
#include "fem/pipeline/coupling/study_load.h"
#include "ring_model/friction_law.h"
#include "ring_model/hand_drive.h"

namespace stemware::pipeline
{

ring::TimedTorqueFunction driven_torque(const Study &study, const std::shared_ptr<ElasticFoot> &foot,
                                        const ring::OrbitSpeedTable &speeds)
{
  const ring::Motion &motion = study.motion.orbit;
  if (!study.load.is_from_contact())
    return ring::driven_torque(study.motion.closure, motion, study.glass.profile.contact_radius, speeds);
  return
    [foot, speeds, motion, tilts = study.tilts(), moments = moment_balance(study)](double time, double omega)
  {
    ContactBalance balance = { moments, tilts };
    balance.moments.motion = speeds.motion_at(motion, time);
    const LeaningLoad load = BalancedContact(foot, balance).at(omega);
    return ring::wrench(balance.moments.motion, load.rings, omega).torque + load.lean_torque();
  };
}

} // namespace stemware::pipeline
