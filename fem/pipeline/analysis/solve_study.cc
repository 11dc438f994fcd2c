#include "fem/pipeline/analysis/solve_study.h"

#include "fem/pipeline/coupling/coupled_load.h"
#include "fem/pipeline/study/study.h"

#include <algorithm>
#include <cmath>
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

fem::ResolvedFriction friction_of(const FootContact &contact, const FootContactResult &result,
                                  const ring::Motion &motion, double omega)
{
  return fem::resolved_friction(contact.point_forces(result), motion.friction_coefficient, omega,
                                motion.orbit_speed);
}

/// Contact of the glass that does not spin yet; friction that deforms the foot is that of omega = 0.
ContactFigures solve_foot_contact(const Study &study, FootContact &contact, const StudyObserver &observer)
{
  ContactFigures figures;
  figures.body = contact.name();
  figures.friction_coupling = study.friction_deforms_foot() ? "elastic" : "none";
  figures.n_cells = contact.n_cells();
  figures.n_unknowns = contact.n_unknowns();
  figures.n_contact_nodes = contact.n_contact_nodes();
  figures.mesh_report = contact.mesh_report();
  figures.result = contact.solve(study.required_resultants(), 0, observer.newton_step);
  figures.footprint = contact.footprint(figures.result);
  figures.friction_at_rest = friction_of(contact, figures.result, study.motion.orbit, 0);
  tell(observer.stage_done, "contact");
  tell(observer.contact_found, contact, figures.result);
  return figures;
}

/// Friction of the glass at its terminal spin, of the pressure where it lies.
fem::ResolvedFriction friction_at_terminal(const Study &study, const RingLoad &load, double omega,
                                           FootContact &foot, const FootContactResult &at_rest)
{
  const ring::Motion &motion = study.motion.orbit;
  if (!load.coupling)
    return friction_of(foot, at_rest, motion, omega);
  const ring::AngularLoad terminal = load.at_spin(omega);
  const FootContactResult result =
    foot.solve({ terminal.normal_force(), terminal.moment().x(), terminal.moment().y() },
               omega / motion.orbit_speed, {});
  return friction_of(foot, result, motion, omega);
}

/// The load for the curves that are shown beside the spin-up: on their way from rest to the terminal spins.
LoadAtSpin load_beside(const StudyResult &result)
{
  const double all = result.yaw.terminal.omega;
  const double first = result.yaw.truncations.front().omega_terminal;
  const double margin = 0.02 * std::max(std::abs(all), std::abs(first));
  return for_many_spins(result.load, std::min({ 0., all - margin, first - margin }),
                        std::max({ 0., all + margin, first + margin }));
}

StudyLoad find_contact_load(const Study &study, fem::ComplianceStore &store, const StudyObserver &observer)
{
  const std::shared_ptr<FootContact> foot = make_foot_contact(study, store);
  tell(observer.foot_made, *foot);
  tell(observer.stage_done, "mesh_and_stiffness");
  if (const std::string note = friction_note(study); !note.empty())
    tell(observer.note, "Friction", note);
  if (const std::string note = frozen_note(study); !note.empty())
    tell(observer.note, "Coupling", note);
  const ContactFigures contact = solve_foot_contact(study, *foot, observer);
  if (study.has_waviness())
  {
    const PhasedLoad phased = find_phased_load(study, foot, contact.result.load, observer.balance_found);
    return { phased.load, foot, contact, phased };
  }
  return { contact_load(study, foot, contact.result.load, observer.balance_found), foot, contact,
           std::nullopt };
}

/// Spin under a load that depends on the phase.
void follow_phases(const Study &study, const PhasedLoad &load, FootContact &foot, StudyResult &result)
{
  const ring::Motion &motion = study.motion.orbit;
  PhaseFigures figures;
  result.yaw = study_yaw(load, phase_periods(imperfection_of(study)), motion, figures);
  result.spin_up = spin_up_curves(load, study.motion);
  result.phases = figures;
  foot.turn_to(phase_of_marks(motion, 0, 0));
}

} // namespace

StudyLoad find_load(const Study &study, const StudyObserver &observer)
{
  fem::ComplianceStore store;
  return find_load(study, store, observer);
}

StudyLoad find_load(const Study &study, fem::ComplianceStore &store, const StudyObserver &observer)
{
  switch (study.load.source)
  {
  case LoadSource::contact:
    return find_contact_load(study, store, observer);
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
                         {},
                         compare_closures(motion, study.glass.profile.contact_radius) };
  if (found.phased)
    follow_phases(study, *found.phased, *found.foot, result);
  else
    result.spin_up = spin_up_curves(load, study.motion, load_beside(result));
  if (result.contact)
    result.contact->friction_at_terminal = friction_at_terminal(study, result.load, result.yaw.terminal.omega,
                                                                *found.foot, result.contact->result);
  tell(observer.stage_done, "ring");
  return result;
}

} // namespace stemware::pipeline
