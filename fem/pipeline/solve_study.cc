#include "fem/pipeline/solve_study.h"

#include "fem/pipeline/contact_demand.h"
#include "fem/pipeline/coupled_load.h"

#include <stdexcept>

namespace stemware::pipeline
{

namespace
{

/// Calls @p report if the caller wants to hear it.
template <typename Report, typename... What>
void tell(const Report &report, const What &...what)
{
  if (report)
    report(what...);
}

/// Contact of the glass that does not spin yet.
ContactFigures solve_foot_contact(const fem::ContactLoad &demand, FootContact &contact,
                                  const StudyObserver &observer)
{
  ContactFigures figures;
  figures.body = contact.name();
  figures.n_cells = contact.n_cells();
  figures.n_unknowns = contact.n_unknowns();
  figures.n_contact_nodes = contact.n_contact_nodes();
  figures.mesh_report = contact.mesh_report();
  figures.result = contact.solve(demand, 0, observer.newton_step);
  tell(observer.stage_done, "contact");
  tell(observer.contact_found, contact, figures.result);
  return figures;
}

/// Friction of the pressure where it lies, beside that of the ring.
void resolve_friction(const Study &study, const RingLoad &load, double omega_terminal, FootContact &foot,
                      ContactFigures &contact)
{
  const ring::Motion &motion = study.motion.orbit;
  const auto friction = [&](const std::vector<fem::PointForce> &forces, double omega)
  { return fem::resolved_friction(forces, motion.friction_coefficient, omega, motion.orbit_speed); };
  contact.friction_at_rest = friction(contact.result.point_forces, 0);
  if (study.load.coupling == LoadCoupling::frozen)
  {
    contact.friction_at_terminal = friction(contact.result.point_forces, omega_terminal);
    return;
  }
  const ring::AngularLoad terminal = load.at_spin(omega_terminal);
  const FootContactResult result =
    foot.solve({ terminal.normal_force(), terminal.moment().x(), terminal.moment().y() },
               omega_terminal / motion.orbit_speed, {});
  contact.friction_at_terminal = friction(result.point_forces, omega_terminal);
}

StudyLoad find_contact_load(const Study &study, const StudyObserver &observer)
{
  const std::shared_ptr<FootContact> foot = make_foot_contact(study);
  tell(observer.foot_made, *foot);
  tell(observer.stage_done, "mesh_and_stiffness");
  const ContactFigures contact = solve_foot_contact(demanded_load(study), *foot, observer);
  const fem::LoadHarmonics &at_rest = contact.result.load;
  const RingLoad load = study.load.coupling == LoadCoupling::exact
                          ? coupled_contact_load(study, foot, at_rest, observer.balance_found)
                          : frozen_contact_load(at_rest, study.glass.profile.contact_radius);
  return { load, foot, contact };
}

} // namespace

StudyLoad find_load(const Study &study, const StudyObserver &observer)
{
  switch (study.load.source)
  {
  case LoadSource::contact:
    return find_contact_load(study, observer);
  case LoadSource::first_harmonic:
    return { first_harmonic_load(study), nullptr, std::nullopt };
  case LoadSource::file:
    return { load_from_file(study), nullptr, std::nullopt };
  }
  throw std::logic_error("a load source without a load");
}

StudyResult solve_study(const Study &study, const StudyObserver &observer)
{
  StudyLoad found = find_load(study, observer);
  const ring::Motion &motion = study.motion.orbit;
  const LoadAtSpin load = found.load.at_spin;
  StudyResult result = { std::move(found.load),
                         std::move(found.contact),
                         study_yaw(load, motion),
                         torque_curve(load, motion),
                         spin_up_curves(load, study.motion),
                         compare_closures(motion, study.glass.profile.contact_radius) };
  if (result.contact)
    resolve_friction(study, result.load, result.yaw.terminal.omega, *found.foot, *result.contact);
  tell(observer.stage_done, "ring");
  return result;
}

} // namespace stemware::pipeline
