#include "fem/pipeline/coupling/driven_load.h"

#include "fem/contact/contact_newton.h"
#include "fem/pipeline/coupling/balanced_contact.h"
#include "fem/pipeline/coupling/study_load.h"
#include "fem/pipeline/support/failures.h"
#include "fem/pipeline/support/numbers.h"
#include "fem/pipeline/support/text.h"
#include "ring_model/friction_law.h"
#include "ring_model/hand_drive.h"

namespace stemware::pipeline
{

ring::PhasedTorqueFunction driven_torque(const Study &study, const std::shared_ptr<ElasticFoot> &foot,
                                         const ring::OrbitSpeedTable &speeds)
{
  const ring::Motion &motion = study.motion.orbit;
  if (!study.load.is_from_contact())
    return ring::driven_torque(study.motion.closure, motion, study.glass.profile.contact_radius, speeds);
  return [foot, speeds, motion, of_study = moment_balance(study),
          file = study.motion.orbit_speed_file](double time, double, double omega)
  {
    ContactBalance balance = of_study;
    balance.motion = speeds.motion_at(motion, time);
    try
    {
      BalancedContact contacts(foot, balance);
      const ring::LeaningLoad load = contacts.load_of(contacts.contact(omega));
      return ring::wrench(balance.motion, load, omega).torque + load.lean_torque();
    }
    catch (const fem::ContactFailure &failure)
    {
      if (failure.outcome != fem::ContactOutcome::tipping)
        throw;
      throw BadInput(filled(
        "Motion/Orbit speed file = {}: at t = {} s, where v = {} m/s and dv/dt = {} m/s^2, the glass falls "
        "over; give lower speeds, or more rows where the speed changes.",
        { shortened_path(file), to_short_text(time), to_short_text(balance.motion.orbit_speed),
          to_short_text(balance.motion.orbit_acceleration) }));
    }
  };
}

} // namespace stemware::pipeline
