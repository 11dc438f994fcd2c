#include "fem/pipeline/report/run_results.h"

#include "fem/pipeline/document/run_answer.h"
#include "fem/pipeline/document/sentences.h"
#include "fem/pipeline/document/shown_rows.h"
#include "fem/pipeline/document/study_words.h"
#include "fem/pipeline/input/data_files.h"
#include "fem/pipeline/input/study_file.h"
#include "fem/pipeline/report/common_sections.h"
#include "fem/pipeline/report/foot_pictures.h"

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
Json friction_rows(const Study &study, const ring::Answer &all)
{
  const ring::RingStack &load = all.at_rest.value().load;
  const double force = study.motion.orbit.friction_at_rest() * load.normal_force();
  const double torque = force * load.radius();
  Json rows = Json::array();
  const auto add = [&](const char *name, const ring::RingState &state)
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
  zero_rounding_errors(rows, "torque lean_torque grip_torque", 1e-12 * torque);
  zero_rounding_errors(rows, "torque_sum", 1e-9 * torque);
  zero_rounding_errors(rows, "force", 1e-12 * force);
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
ring::Status status_of(const ContactReport &report, const SpinStudy &spin)
{
  const ring::Status status = spin.all().status;
  if (status == ring::Status::full_contact && report.load_at_end.contact_fraction < 1)
    return ring::Status::lift_off;
  // The series of a pressure that ends somewhere dips below zero there; the pressure does not.
  return status == ring::Status::formal && report.foot ? ring::Status::lift_off : status;
}

/// All terminal spins with their stability, and which one is reached from rest.
Json terminal_spins_summary(const SpinStudy &spin)
{
  Json spins = Json::array();
  for (const ring::TerminalSpin &one : spin.terminal_spins)
    spins.push_back({ { "omega", one.omega },
                      { "stable", one.stable },
                      { "held", one.held },
                      { "torque_slope", finite_or_null(one.torque_slope) },
                      { "time_constant", finite_or_null(one.time_constant) },
                      { "from_rest", spin.all().terminal && one.omega == spin.all().terminal->omega } });
  return spins;
}

Json driven_summary(const DrivenSpinUp &driven)
{
  Json summary = { { "speed_at_end", driven.speed.back() }, { "omega_at_end", driven.omega.back() } };
  summary.update(STEMWARE_JSON(driven, interpolation_change, interpolation_change_at_end));
  summary["band_at_end"] = driven.band_at_end ? Json(*driven.band_at_end) : Json(nullptr);
  summary["breakaway"] = to_json_or_null(driven.breakaway,
                                         [](const ring::Breakaway &start)
                                         {
                                           Json fields = STEMWARE_JSON(start, time, force, moment_ratio);
                                           fields["friction_coefficient"] = start.motion.friction_coefficient;
                                           return fields;
                                         });
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

/// M_Nx of the load of which ring::Answer::at_rest is: of a wavy rim or table the mean over the phases, as
/// its torque.
double moment_at_rest(const ContactReport &report, const SpinStudy &spin)
{
  return spin.phases ? spin.all().at_rest.value().load.moment().x() : report.load.moment.x();
}

Json ring_summary(const Study &study, const ContactReport &report, const SpinStudy &spin)
{
  const ring::Answer &all = spin.all();
  Json ring = spin_rows({ all })[0];
  ring.update(
    { { "tau_closed_form", study.motion.orbit.friction_at_rest() * moment_at_rest(report, spin) },
      { "standing", to_string(status_of(report, spin)) },
      { "fall", fall_summary(all) },
      { "terminal_spins", terminal_spins_summary(spin) },
      { "driven", to_json_or_null(spin.spin_up.driven, driven_summary) },
      { "no_lift_off", has_no_lift_off(report) },
      { "tilt_at_terminal",
        all.terminal ? Json{ report.load_at_end.tilt.x(), report.load_at_end.tilt.y() } : Json(nullptr) },
      { "phase_dependent", spin.phases.has_value() },
      { "spin_ripple", spin.phases ? spin.phases->spin_ripple : 0 } });
  return declared(ring, "ring");
}

/// Summary of the effects of an out-of-flat rim or table.
Json waviness_summary(const PhaseStudy &phases, const LoadReport &at_rest)
{
  Json summary =
    STEMWARE_JSON(phases, spin_ripple, spin_uncertainty, zero_of_mean_torque, torque_ripple, least_load,
                  least_contact_fraction, n_glass_phases, n_table_phases, n_spins, interpolation_error);
  const bool is_at_rest = !at_rest.over_phases || phases.least_load >= at_rest.over_phases->least_load;
  summary["least_load_state"] = is_at_rest ? "at rest" : "at the terminal spin";
  return summary;
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

Json coupling_summary(const CouplingStatistics &coupling, const std::optional<double> &curve_error)
{
  return { { "balanced_spins", coupling.n_balances },
           { "contact_solutions", coupling.n_contact_solutions },
           { "response_error", nullptr }, // none is interpolated in the moment ratio
           { "interpolation_error", curve_error } };
}

Findings findings_of(const Study &study, const ContactReport &report, const SpinStudy &spin,
                     const std::vector<BandedQuantity> &bands, const std::optional<GoalOutcome> &goal)
{
  Findings findings;
  findings.summary = {
    { "load", load_summary(report.load) },
    { "load_at_terminal", spin.all().terminal ? load_summary(report.load_at_end) : Json(nullptr) },
    { "load_at_fall", spin.all().fall ? load_summary(report.load_at_end) : Json(nullptr) },
    { "contact", to_json_or_null(report.foot, contact_summary) },
    { "ring", ring_summary(study, report, spin) },
    { "coupling", to_json_or_null(report.coupling, [&](const CouplingStatistics &coupling)
                                  { return coupling_summary(coupling, spin.curve_error); }) },
    { "waviness", to_json_or_null(spin.phases, [&](const PhaseStudy &phases)
                                  { return waviness_summary(phases, report.load); }) },
    { "budget", spin.is_quick() ? Json(nullptr) : budget_summary(study, spin.budget.rows) },
    { "without", spin.is_quick() ? Json(nullptr) : declared(without_rows(study, spin.budget), "without") },
    { "harmonic_effect", harmonic_effect_summary(spin.budget.harmonics) },
    { "torque_effect", torque_effect_summary(spin.torque_effects) },
    { "one_ring", spin.one_ring ? selected_keys(spin_rows({ *spin.one_ring })[0],
                                                "tau_at_rest omega_terminal relative_change")
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

constexpr char without_keys[] = "name omega_terminal difference relative_difference remark";

/// without_rows() for people.
Json shown_without(const Study &study, const Budget &budget)
{
  Json without = without_rows(study, budget);
  zero_rounding_errors(without, "difference", rounding_of_spins(study));
  zero_rounding_errors(without, "relative_difference", 1e-9);
  return without;
}

void add_spin(const Study &study, const ContactReport &report, const SpinStudy &spin, Document &document)
{
  const ring::Motion &motion = study.motion.orbit;
  const double radius = study.glass.profile.contact_radius;
  add_slip_columns("slip_at_rest", motion, radius, report.load.rings, 0, document);
  if (const auto omega = spin.all().omega_terminal(); omega && is_spin(study, *omega))
    add_slip_columns("slip_at_end", motion, radius, report.load_at_end.rings, *omega, document);
  add_torque_columns(spin.torque, {}, document);
  add_spin_up_columns(spin.spin_up, 1, document);
  if (!spin.spin_up.instants.empty())
    add_motion(study, spin.spin_up.instants, document);
  if (spin.phases)
    add_phase_columns(*spin.phases, document);
  document.add_rows("friction", friction_rows(study, spin.all()),
                    "name torque lean_torque grip_torque torque_sum force[]");
  add_truncations(truncation_rows(spin.rows, spin.torque_effects, spin_scale(study)), spin.torque_effects,
                  document);
}

void add_budget(const Study &study, const SpinStudy &spin, Document &document)
{
  const Json chain = shown_chain(study, spin.budget.rows);
  document.add_rows("chain", chain, "step title omega_terminal difference relative_difference band remark");
  document.add_rows("chain_torques", chain, "step title torques[]", "chain");
  document.tables["waterfall"] = chain_rows(study, named_steps(spin.budget.rows));
  if (!spin.budget.without.empty())
    document.add_rows("without", shown_without(study, spin.budget), without_keys);
}

Json words_of(const Study &study, const ContactReport &report, const SpinStudy &spin, const ErrorBands &bands)
{
  std::string answer = run_answer(study, spin, bands);
  append(answer, profile_remark(study));
  return { { "answer", answer },
           { "lift_off", lift_off_remark(study, report, spin) },
           { "pressed", contact_remark(report, spin, bands) },
           { "narrow_contact", narrow_contact_remark(study, report) },
           { "thin_layer", thin_layer_remark(study, report.load.half_width()) },
           { "out_of_flat", out_of_flat_remark(study, spin) },
           { "several_spins", several_spins_remark(spin) },
           { "driven", driven_remark(spin) },
           { "spin_unit", spin_unit(study) },
           { "rounding", rounding_of_spins(study) } };
}

void add_foot_files(const FootReport &foot, bool has_terminal_spin, std::vector<ResultFile> &files)
{
  files.push_back({ "footprint.csv", "pressure p(r, θ) of the foot on the table at rest",
                    footprint_table(foot.footprint) });
  if (foot.footprint_at_end && has_terminal_spin)
    files.push_back(
      { "footprint_at_end.csv", "the same at the terminal spin", footprint_table(*foot.footprint_at_end) });
  files.push_back(
    { "contact_history.csv", "Newton steps of the contact", history_table(foot.at_rest.history) });
  const auto add = [&](const std::string &name, const char *state)
  {
    files.push_back({ "fields/" + name, "displacement, strain, stress and contact pressure " +
                                          std::string(state) + ", for ParaView" });
  };
  for (const fem::FieldFile &file : foot.fields)
  {
    if (file.name == "contact.vtu" || file.name == "contact.pvtu") // and not a piece of the latter
      add(file.name, "at rest");
    if (file.name.find("_at_terminal_spin") != std::string::npos)
      add(file.name, "at the terminal spin");
  }
}

std::vector<ResultFile> files_of(const Study &study, const ContactReport &report, const SpinStudy &spin)
{
  const ring::RingStack &rings = report.load.rings;
  std::vector<ResultFile> files = { { "summary.json", "all numbers, for programs" },
                                    { "parameters.prm", "the study as input file" },
                                    { "load.csv", "λ(θ) at rest", load_table(rings) },
                                    { "harmonics.dat", "its Fourier coefficients, readable by Load/File",
                                      load_file_text(rings) },
                                    { "rings.csv", "the same ring by ring", ring_table(rings) } };
  const auto add = [&](const char *name, const char *words, const Table &table) {
    files.push_back({ name, words, table });
  };
  if (!spin.is_quick())
  {
    add("budget.csv", "the terminal spin from the paper's model to this study's",
        table_of(chain_rows(study, spin.budget.rows),
                 "step title harmonics_kept omega_terminal difference band formal torques[]", "chain"));
    add("without.csv", "the complete model without one effect at a time",
        table_of(without_rows(study, spin.budget), "name omega_terminal difference reason", "without"));
  }
  add("torque.csv", "τ_z, T_x, T_y against the spin", torque_table(spin.torque));
  add("spin_up.csv", "the spin against time", spin_up_table(spin.spin_up));
  add("truncation.csv", "the answer with 1, 2, 3, 4, 6, 8 ... harmonics",
      truncation_table(truncation_rows(spin.rows, spin.torque_effects, spin_scale(study))));
  if (spin.spin_up.driven)
    add("driven_spin_up.csv", "the spin against time under the speeds of the file",
        driven_spin_table(*spin.spin_up.driven));
  if (spin.phases)
    add("phases.csv", "τ_z by the orientation of glass and table", phase_table(*spin.phases));
  if (study.load.is_from_contact())
  {
    add("load_lines.csv", "λ(θ) at rest on the azimuth lines of the contact",
        pointwise_table(report.load.pointwise));
    if (report.foot)
      add_foot_files(*report.foot, spin.all().terminal.has_value(), files);
  }
  files.push_back({ "timings.json", "how long it took" });
  return files;
}

std::vector<ConsoleBlock> console_of(const Study &study, const SpinStudy &spin, const Document &document)
{
  std::string text;
  for (const char *part :
       { "answer", "lift_off", "pressed", "narrow_contact", "thin_layer", "out_of_flat", "several_spins" })
    append(text, document.words[part]);
  std::vector<ConsoleBlock> blocks = { { text } };
  if (!spin.is_quick())
  {
    blocks.push_back(
      { "From the paper's model to this study's:",
        table_of(shown_chain(study, named_steps(spin.budget.rows)),
                 "console_title omega_terminal difference relative_difference band remark", "chain") });
    if (!spin.budget.without.empty())
      blocks.push_back({ "The complete model without one effect at a time:",
                         table_of(shown_without(study, spin.budget), without_keys, "without") });
  }
  return blocks;
}

} // namespace

Results make_document(const Study &study, const ContactReport &report, const SpinStudy &spin,
                      const std::vector<BandedQuantity> &bands, const std::optional<GoalOutcome> &goal)
{
  Results results = { document_of(study, "how fast it spins") };
  results.findings = findings_of(study, report, spin, bands, goal);
  results.words.update(words_of(study, report, spin, bands));
  add_spin(study, report, spin, results);
  if (!spin.is_quick())
    add_budget(study, spin, results);
  add_load_lines(report.load, results);
  if (report.foot)
    add_foot_pictures(study, *report.foot, bands, results);
  if (report.foot)
    results.add_list("contact");
  if (!bands.empty())
    add_bands(bands, results);
  results.files = files_of(study, report, spin);
  results.console = console_of(study, spin, results);
  return results;
}

std::optional<double> band_of_mesh(const Study &study, const ErrorBands &bands)
{
  const auto banded = find_quantity(bands, key_of(study.contact.goal));
  if (banded == bands.end() || banded->parts.count("mesh") == 0)
    return std::nullopt;
  return banded->parts.at("mesh");
}

} // namespace stemware::pipeline
