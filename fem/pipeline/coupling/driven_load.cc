#include "fem/pipeline/coupling/driven_load.h"

#include "fem/pipeline/base/failures.h"
#include "fem/pipeline/base/numbers.h"
#include "fem/pipeline/base/text.h"
#include "fem/pipeline/coupling/balanced_contact.h"
#include "fem/pipeline/coupling/study_load.h"
#include "ring_model/failures.h"

namespace stemware::pipeline
{

namespace
{

/// Returns the result of @p solve. If the glass tips, throws BadInput with the text that @p sentence returns.
template <typename Solve, typename Sentence>
auto unless_it_tips(const Solve &solve, const Sentence &sentence)
{
  try
  {
    return solve();
  }
  catch (const ring::Tipping &)
  {
    throw BadInput(sentence());
  }
}

} // namespace

ring::PhasedTorqueFunction driven_torque(const Study &study, const std::shared_ptr<ElasticFoot> &foot,
                                         const ring::OrbitSpeedTable &speeds)
{
  const ring::DrivenLoad load =
    [foot, of_study = moment_balance(study), file = study.motion.orbit_speed_file](const ring::Motion &now,
                                                                                   double time, double omega)
  {
    ContactBalance balance = of_study;
    balance.motion = now;
    const auto solve = [&]
    {
      BalancedContact contacts(foot, balance);
      return contacts.sample_of(contacts.contact(omega));
    };
    const auto sentence = [&]
    {
      return filled(
        "Motion/Orbit speed file = {}: at t = {} s, where v = {} m/s and dv/dt = {} m/s^2, the glass "
        "tips; give lower speeds, or more rows where the speed changes.",
        { shortened_path(file), to_short_text(time), to_short_text(now.orbit_speed),
          to_short_text(now.orbit_acceleration) });
    };
    return unless_it_tips(solve, sentence);
  };
  return study.load.is_from_contact() ? ring::driven_torque(study.motion.orbit, speeds, load)
                                      : ring::driven_torque(study.motion.closure, study.motion.orbit,
                                                            study.glass.profile.contact_radius, speeds);
}

ring::Breakaway find_breakaway(const Study &study, const std::shared_ptr<ElasticFoot> &foot,
                               const ring::OrbitSpeedTable &speeds)
{
  const double radius = study.glass.profile.contact_radius;
  ContactBalance balance = moment_balance(study);
  ring::Breakaway breakaway = ring::find_breakaway(study.motion.closure, study.motion.orbit,
                                                   study.motion.breakaway_friction, radius, speeds);
  const auto tipping_message = [&]
  {
    return filled("Motion/Orbit speed file = {}: the glass tips at t = {} s, before the hand's force reaches "
                  "the {} N at which it slides; hold the glass lower, or reduce the friction.",
                  { shortened_path(study.motion.orbit_speed_file), to_short_text(breakaway.time),
                    to_short_text(breakaway.force) });
  };
  if (!study.load.is_from_contact())
  {
    if (breakaway.moment_ratio >= 2)
      throw BadInput(tipping_message());
    return breakaway;
  }
  balance.motion = breakaway.motion;
  const auto solve = [&] { return BalancedContact(foot, balance).contact(0).load.moment().norm(); };
  breakaway.moment_ratio =
    2 * unless_it_tips(solve, tipping_message) / (balance.motion.normal_force() * radius);
  return breakaway;
}

} // namespace stemware::pipeline
