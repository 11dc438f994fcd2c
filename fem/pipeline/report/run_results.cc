#include "fem/pipeline/report/run_results.h"

#include "fem/pipeline/document/spin_rows.h"
#include "fem/pipeline/report/common_sections.h"
#include "fem/pipeline/report/head.h"
#include "fem/pipeline/report/plots/plots.h"
#include "fem/pipeline/study/data_files.h"
#include "fem/pipeline/study/study_file.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <stdexcept>

namespace stemware::pipeline
{

namespace
{

using Json = nlohmann::ordered_json;

/// The torques on the glass and the friction of the table at rest, then at the terminal spin or where the
/// glass falls over, for people.
Json friction_rows(const Study &study, const SpinRow &all)
{
  const ring::RingStack &load = all.at_rest.value().load;
  const double force = study.motion.orbit.friction_at_rest() * load.normal_force();
  const double torque = force * load.radius();
  Json rows = Json::array();
  const auto add = [&](const char *name, const RingState &state)
  {
    rows.push_back({ { "name", name },
                     { "torque", state.friction.torque },
                     { "lean_torque", state.lean_torque },
                     { "grip_torque", state.grip_torque },
                     { "torque_sum", state.torque() },
                     { "force", { state.friction.force_x, state.friction.force_y } } });
  };
  add("at rest", *all.at_rest);
  if (all.fall)
    add("where it falls over", all.fall->state);
  else if (all.at_terminal)
    add("at the terminal spin", *all.at_terminal);
  leave_out_rounding(rows, "torque lean_torque grip_torque", 1e-12 * torque);
  leave_out_rounding(rows, "torque_sum", 1e-9 * torque);
  leave_out_rounding(rows, "force", 1e-12 * force);
  return rows;
}

// ---- summary.json

/// Whether the load pushes everywhere, at rest and at the end of the spin-up.
bool has_no_lift_off(const ContactReport &report)
{
  const auto pushes = [](const LoadReport &load) { return load.minimum >= 0 && load.contact_fraction >= 1; };
  return pushes(report.load) && pushes(report.load_at_end);
}

/// How the glass stands at the end of the spin-up.
Standing standing_of(const ContactReport &report, const SpinStudy &spin)
{
  const Standing standing = spin.all().standing;
  if (standing == Standing::full_contact && report.load_at_end.contact_fraction < 1)
    return Standing::lift_off;
  // The series of a pressure that ends somewhere dips below zero there; the pressure does not.
  return standing == Standing::formal && report.foot ? Standing::lift_off : standing;
}

/// All terminal spins with their stability, and which one is reached from rest.
Json terminal_spins_summary(const SpinStudy &spin)
{
  Json spins = Json::array();
  for (const ring::TerminalSpin &one : spin.terminal_spins)
    spins.push_back({ { "omega", one.omega },
                      { "stable", one.stable },
                      { "held", one.held },
                      { "torque_slope", if_finite(one.torque_slope) },
                      { "time_constant", if_finite(one.time_constant) },
                      { "from_rest", spin.all().terminal && one.omega == spin.all().terminal->omega } });
  return spins;
}

/// terminal_spins_summary() in words.
Json shown_terminal_spins(const SpinStudy &spin)
{
  Json spins = terminal_spins_summary(spin);
  for (Json &one : spins)
  {
    one["stability"] = one["held"] == true     ? "held by the fingers"
                       : one["stable"] == true ? "stable"
                                               : "unstable";
    one["reached"] = one["from_rest"] == true ? "reached from rest" : "";
  }
  return spins;
}

Json driven_summary(const DrivenSpinUp &driven)
{
  Json summary = { { "speed_at_end", driven.speed.back() }, { "omega_at_end", driven.omega.back() } };
  summary.update(STEMWARE_JSON(driven, interpolation_change, interpolation_change_at_end));
  return summary;
}

/// Size of the finite-element system and residuals of the contact at rest.
Json contact_summary(const FootReport &report)
{
  const fem::FootDescription &foot = report.foot;
  const fem::ContactSolution &solution = report.at_rest.solution;
  Json mesh = Json::object();
  if (foot.n_cells)
    mesh["cells"] = *foot.n_cells;
  if (foot.mesh_report)
    mesh.update(STEMWARE_JSON(*foot.mesh_report, round_rim, rim_radius, land_area_deficit));
  Json summary = { { "body", foot.body },
                   { "friction_coupling", report.friction_coupling },
                   { "outcome", fem::to_string(solution.outcome) },
                   { "mesh", mesh } };
  summary.update(STEMWARE_JSON(foot, n_unknowns, n_contact_nodes));
  summary.update(STEMWARE_JSON(solution, n_loaded_nodes, n_nodes_across, n_iterations, n_linear_iterations,
                               force_residual, moment_residual, equilibrium_residual));
  summary["table_motion"] = { solution.motion(0), solution.motion(1), solution.motion(2) };
  return summary;
}

/// The mesh that was made for a number, what is estimated to be missing to that, and the part of its band
/// that is the mesh's.
Json goal_summary(const Study &study, const GoalOutcome &goal, const FootReport &foot,
                  const ErrorBands &bands)
{
  const Json entries = study_as_json(study)["Contact"];
  return { { "name", entries["Goal"] },
           { "value", goal.value },
           { "estimated_error", goal.estimated_error },
           { "band_of_mesh", band_of_mesh(study, bands) },
           { "tolerance", entries["Goal tolerance"] },
           { "meshes", goal.n_meshes },
           { "cells", goal.n_cells },
           { "unknowns", foot.foot.n_unknowns } };
}

/// Where the glass falls over on its way to a terminal spin.
Json fall_summary(const Fall &fall)
{
  return { { "omega", fall.omega }, { "moment_ratio", fall.state.moment_ratio } };
}

/// M_Nx of the load of which SpinRow::at_rest is: of a wavy rim or table the mean over the phases, as its
/// torque.
double moment_at_rest(const ContactReport &report, const SpinStudy &spin)
{
  return spin.phases ? spin.all().at_rest.value().load.moment().x() : report.load.moment.x();
}

/// The points that are drawn beside the spin-up.
std::vector<MeasuredSpin> measured_spins(const Study &study)
{
  const std::string &file = study.motion.measured_spin_file;
  return file.empty() ? std::vector<MeasuredSpin>() : read_measured_spin_file(file);
}

Json ring_summary(const Study &study, const ContactReport &report, const SpinStudy &spin)
{
  const SpinRow &all = spin.all();
  const bool is_measured = !study.motion.measured_spin_file.empty();
  Json ring = spin_rows({ all })[0];
  ring.update(
    { { "tau_closed_form", study.motion.orbit.friction_at_rest() * moment_at_rest(report, spin) },
      { "standing", to_string(standing_of(report, spin)) },
      { "fall", if_there(all.fall, fall_summary) },
      { "terminal_spins", terminal_spins_summary(spin) },
      { "driven", if_there(spin.spin_up.driven, driven_summary) },
      { "measured", is_measured ? Json{ { "points", measured_spins(study).size() } } : Json(nullptr) },
      { "no_lift_off", has_no_lift_off(report) },
      { "tilt_at_terminal",
        all.terminal ? Json{ report.load_at_end.tilt.x(), report.load_at_end.tilt.y() } : Json(nullptr) },
      { "phase_dependent", spin.phases.has_value() },
      { "spin_ripple", spin.phases ? spin.phases->spin_ripple : 0 } });
  return declared(ring, "ring");
}

/// Summary of the effects of an out-of-flat rim or table.
Json waviness_summary(const PhaseStudy &phases)
{
  return STEMWARE_JSON(phases, spin_ripple, spin_uncertainty, zero_of_mean_torque, torque_ripple, least_load,
                       least_contact_fraction, n_glass_phases, n_table_phases, n_spins, interpolation_error);
}

/// Summary of a drawn profile and the circle of its rim.
Json profile_summary(const GlassSection &glass)
{
  const auto &circle = glass.rim_circle;
  return { { "points", glass.n_profile_points },
           { "contact_radius", glass.profile.contact_radius },
           { "crown_radius", glass.profile.crown_radius },
           { "rim_points", circle ? circle->n_points : 0 },
           { "rms_distance", circle ? Json(circle->rms_distance) : Json(nullptr) } };
}

Json coupling_summary(const CouplingStatistics &coupling)
{
  return { { "balanced_spins", coupling.n_balances },
           { "contact_solutions", coupling.n_contact_solutions },
           { "response_error", nullptr }, // none is interpolated in the moment ratio
           { "interpolation_error", coupling.interpolation_error } };
}

Findings findings_of(const Study &study, const ContactReport &report, const SpinStudy &spin,
                     const std::vector<BandedQuantity> &bands, const std::optional<GoalOutcome> &goal)
{
  Findings findings;
  findings.summary = {
    { "load", load_summary(report.load) },
    { "load_at_terminal", spin.all().terminal ? load_summary(report.load_at_end) : Json(nullptr) },
    { "load_at_fall", spin.all().fall ? load_summary(report.load_at_end) : Json(nullptr) },
    { "contact", if_there(report.foot, contact_summary) },
    { "ring", ring_summary(study, report, spin) },
    { "coupling", if_there(report.coupling, coupling_summary) },
    { "waviness", if_there(spin.phases, waviness_summary) },
    { "budget", spin.is_quick() ? Json(nullptr) : budget_summary(study, spin.budget.rows) },
    { "without", spin.is_quick() ? Json(nullptr) : declared(without_rows(study, spin.budget), "without") },
    { "harmonic_effect", harmonic_effect_summary(spin.budget.harmonics) },
    { "one_ring", spin.one_ring
                    ? picked(spin_rows({ *spin.one_ring })[0], "tau_at_rest omega_terminal relative_change")
                    : Json(nullptr) }
  };
  if (!bands.empty() || spin.is_quick())
    findings.summary["error_bands"] = spin.is_quick() ? Json(nullptr) : band_summary(bands);
  if (study.glass.profile.section)
    findings.summary["profile"] = profile_summary(study.glass);
  if (goal)
    findings.summary["goal"] = goal_summary(study, *goal, report.foot.value(), bands);
  findings.key_figures = { { "tau_at_rest", spin.all().at_rest.value().friction.torque },
                           { "omega_terminal", spin.all().omega_terminal() },
                           { "omega_terminal_band", band_of(bands, "omega_terminal") },
                           { "omega_terminal_first_harmonic", spin.rows.front().omega_terminal() },
                           { "harmonic_effect", spin.budget.harmonics.absolute },
                           { "harmonic_effect_relative", spin.budget.harmonics.relative } };
  return findings;
}

void add_foot(const Study &study, const FootReport &foot, Document &document)
{
  document.tables["contact_history"] = history_table(foot.at_rest.history);
  document.tables["footprint"] = footprint_table(foot.footprint);
  if (foot.footprint_at_end)
    document.tables["footprint_at_end"] = footprint_table(*foot.footprint_at_end);
  add_foot_plots(study, foot, document);
}

/// omega(t) as the report draws it.
void add_spin_up(const Study &study, const SpinStudy &spin, Document &document)
{
  const SpinUpCurves &curves = spin.spin_up;
  std::vector<SpinCurve> spin_ups = { { "all harmonics", curves.adaptive, 1 } };
  if (!curves.first_harmonic.empty())
    spin_ups.push_back({ "first harmonic", curves.first_harmonic, 2 });
  spin_ups.push_back({ "the paper's model", curves.paper, static_cast<unsigned int>(spin_ups.size()) + 1 });
  add_spin_up_plot(curves.time, spin_ups, spin.all(), measured_spins(study),
                   "Spin-up of the glass from rest.", document);
}

void add_spin(const Study &study, const ContactReport &report, const SpinStudy &spin, Document &document)
{
  std::vector<SlidingState> states = { { "at rest", report.load.rings, 0 } };
  if (const auto omega = spin.all().omega_terminal(); omega && is_spin(study, *omega))
    states.push_back({ "at the terminal spin", report.load_at_end.rings, *omega });
  add_slip_plot(study.motion.orbit, study.glass.profile.contact_radius, states, document);
  add_torque_plot(spin.torque, spin.rows, document);
  add_spin_up(study, spin, document);
  document.plots["phases"] = { { "marked",
                                 spin.phases && spin.phases->n_glass_phases > 1 ? "glass" : "table" } };
  auto &tables = document.tables;
  tables["torque"] = torque_table(spin.torque);
  tables["spin_up"] = spin_up_table(spin.spin_up);
  if (spin.spin_up.driven)
    tables["driven"] = driven_spin_table(*spin.spin_up.driven);
  if (spin.phases)
    tables["phases"] = phase_table(*spin.phases);
  document.facts["friction"] = friction_rows(study, spin.all());
  document.facts["terminal_spins"] = shown_terminal_spins(spin);
  add_truncations(spin.rows, spin.one_ring, document);
}

void add_budget(const Study &study, const SpinStudy &spin, Document &document)
{
  add_chain(study, spin.budget, document);
  Json without = without_rows(study, spin.budget);
  document.facts["without"] = { { "rows", without } };
  leave_out_rounding(without, "difference", rounding_of_spins(study));
  leave_out_rounding(without, "relative_difference", 1e-9);
  document.facts["without"]["shown"] = without;
}

/// The study's glass on its orbit, and the paper's rigid ring beside it.
std::vector<TurningGlass> turning_glasses(const ContactReport &report, const SpinStudy &spin)
{
  const SpinRow &all = spin.all();
  std::vector<TurningGlass> glasses = { { "this glass", all.omega_terminal(), report.load_at_end.rings } };
  const std::vector<double> &paper = spin.spin_up.paper;
  if (!spin.is_quick() && spin.budget.rows.front().omega_terminal)
    glasses.push_back({ "the paper's rigid ring", spin.budget.rows.front().omega_terminal, {}, true });
  else if (paper.size() > 10 &&
           std::abs(paper.back() - paper[paper.size() * 9 / 10]) <= 1e-2 * std::abs(paper.back()))
    glasses.push_back({ "the paper's rigid ring", paper.back(), {}, true }); // its spin-up has ended
  return glasses;
}

} // namespace

Results tabulate(const Study &study, const ContactReport &report, const SpinStudy &spin,
                 const std::vector<BandedQuantity> &bands, const std::optional<GoalOutcome> &goal)
{
  Document document = { findings_of(study, report, spin, bands, goal),
                        run_facts(study, report, spin, bands, goal) };
  add_study(study, turning_glasses(report, spin), document, report.load.rings);
  add_spin(study, report, spin, document);
  if (!spin.is_quick())
    add_budget(study, spin, document);
  add_load(study, report.load, bands, document);
  if (report.foot)
    add_foot(study, *report.foot, document);
  add_bands(bands, document);
  return shown(document, "run");
}

} // namespace stemware::pipeline
