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
      throw BadInput(
        filled("Motion/Orbit speed file = {}: at t = {} s, where v = {} m/s and dv/dt = {} m/s^2, the glass "
               "tips; give lower speeds, or more rows where the speed changes.",
               { shortened_path(file), to_short_text(time), to_short_text(balance.motion.orbit_speed),
                 to_short_text(balance.motion.orbit_acceleration) }));
    }
  };
}

Breakaway find_breakaway(const Study &study, const std::shared_ptr<ElasticFoot> &foot,
                         const ring::OrbitSpeedTable &speeds)
{
  Breakaway breakaway;
  breakaway.time = speeds.time_of(0);
  ring::Motion motion = speeds.motion_at(study.motion.orbit, breakaway.time);
  motion.orbit_acceleration = 0;
  motion.friction_coefficient = motion.has_constant_friction() && study.motion.breakaway_friction > 0
                                  ? study.motion.breakaway_friction
                                  : motion.friction_at(0);
  motion.friction_law = ring::FrictionLawKind::coulomb;
  breakaway.friction_coefficient = motion.friction_coefficient;
  breakaway.force = motion.friction_coefficient * motion.normal_force();
  const double radius = study.glass.profile.contact_radius;
  const auto ratio_of = [&](const Eigen::Vector2d &moment)
  { return 2 * moment.norm() / (motion.normal_force() * radius); };
  breakaway.moment_ratio = ratio_of(ring::required_moment_at_rest(study.motion.closure, motion));
  const BadInput falls_over(
    filled("Motion/Orbit speed file = {}: the glass falls over at t = {} s, before the hand's force reaches "
           "the {} N at which it slides; lead it lower, or reduce the friction.",
           { shortened_path(study.motion.orbit_speed_file), to_short_text(breakaway.time),
             to_short_text(breakaway.force) }));
  if (!study.load.is_from_contact())
  {
    if (breakaway.moment_ratio >= 2)
      throw falls_over;
    return breakaway;
  }
  ContactBalance balance = moment_balance(study);
  balance.motion = motion;
  try
  {
    breakaway.moment_ratio = ratio_of(BalancedContact(foot, balance).contact(0).load.moment());
  }
  catch (const fem::ContactFailure &failure)
  {
    if (failure.outcome != fem::ContactOutcome::tipping)
      throw;
    throw falls_over;
  }
  return breakaway;
}

} // namespace stemware::pipeline
