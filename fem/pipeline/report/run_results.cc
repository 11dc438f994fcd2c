#include "fem/pipeline/report/run_results.h"

#include "fem/pipeline/report/answer.h"
#include "fem/pipeline/report/budget_tables.h"
#include "fem/pipeline/report/common_sections.h"
#include "fem/pipeline/report/driven_spin.h"
#include "fem/pipeline/report/goal_results.h"
#include "fem/pipeline/report/plots/foot_plots.h"
#include "fem/pipeline/report/plots/plots.h"
#include "fem/pipeline/report/profile_results.h"
#include "fem/pipeline/report/quantities.h"
#include "fem/pipeline/report/render/table_renderers.h"
#include "fem/pipeline/report/run_tables.h"
#include "fem/pipeline/report/spin_table.h"
#include "fem/pipeline/report/terminal_spins.h"

#include <boost/math/constants/constants.hpp>

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

/// Terminal spin and torque by the number of harmonics.
Table truncation_table(const SpinStudy &spin)
{
  return spin_table(spin.rows).with(
    "The answer with the load cut off after some harmonics",
    "harmonics tau_at_rest omega_terminal relative_change bound load_minimum");
}

/// truncation_table() for people, with all harmonics on one ring as a further row.
Table shown_truncation_table(const SpinStudy &spin)
{
  constexpr double nothing = 1e-9;
  std::vector<SpinRow> rows;
  std::copy_if(spin.rows.begin(), spin.rows.end(), std::back_inserter(rows),
               [&](const SpinRow &row)
               {
                 return row.harmonics == spin.rows.back().harmonics || !row.relative_change ||
                        std::abs(*row.relative_change) >= nothing;
               });
  std::vector<std::string> names;
  for (const SpinRow &row : rows)
    names.push_back(std::to_string(row.harmonics));
  if (spin.one_ring)
  {
    rows.push_back(*spin.one_ring);
    names.push_back(std::to_string(spin.one_ring->harmonics) + ", on one ring");
  }
  Table table =
    spin_table(rows).with("The answer with the load cut off after some harmonics",
                          "harmonics tau_at_rest omega_terminal relative_change bound load_minimum");
  table.columns.front() = column(quantity::harmonics, names);
  return table;
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

/// What ring_state() of the row's terminal spin has; null where it has none.
template <typename Value>
Json at_terminal(const SpinRow &row, Value value)
{
  return row.at_terminal ? Json(std::invoke(value, *row.at_terminal)) : Json(nullptr);
}

/// Where the glass falls over on its way to a terminal spin; null where it does not.
Json fall_summary(const std::optional<Fall> &fall)
{
  if (!fall)
    return nullptr;
  return { { "omega", fall->omega }, { "moment_ratio", fall->state.moment_ratio } };
}

/// M_Nx of the load of which SpinRow::at_rest is: of a wavy rim or table the mean over the phases, as its
/// torque.
double moment_at_rest(const ContactReport &report, const SpinStudy &spin)
{
  return spin.phases ? spin.all().at_rest.value().load.moment().x() : report.load.moment.x();
}

Json ring_summary(const Study &study, const ContactReport &report, const SpinStudy &spin)
{
  const SpinRow &all = spin.all();
  return { { "tau_at_rest", all.at_rest.value().friction.torque },
           { "tau_closed_form", study.motion.orbit.friction_at_rest() * moment_at_rest(report, spin) },
           { "lean_torque_at_rest", all.at_rest->lean_torque },
           { "standing", to_string(standing_of(report, spin)) },
           { "fall", fall_summary(all.fall) },
           { "omega_terminal", json_number(all.omega_terminal()) },
           { "tau_at_terminal",
             at_terminal(all, [](const RingState &state) { return state.friction.torque; }) },
           { "lean_torque_at_terminal", at_terminal(all, &RingState::lean_torque) },
           { "grip_torque_at_terminal", at_terminal(all, &RingState::grip_torque) },
           { "time_constant", json_number(all.time_constant()) },
           { "terminal_spins", terminal_spins_summary(spin) },
           { "driven", spin.spin_up.driven ? driven_spin_summary(*spin.spin_up.driven) : Json(nullptr) },
           { "no_lift_off", has_no_lift_off(report) },
           { "force_at_terminal", at_terminal(all,
                                              [](const RingState &state) {
                                                return Json{ state.friction.force_x, state.friction.force_y };
                                              }) },
           { "moment_ratio_at_terminal", at_terminal(all, &RingState::moment_ratio) },
           { "tilt_at_terminal", all.terminal ? Json{ report.tilt.x(), report.tilt.y() } : Json(nullptr) },
           { "phase_dependent", spin.phases.has_value() },
           { "spin_ripple", spin.phases ? spin.phases->spin_ripple : 0 } };
}

/// What an out-of-flat rim or table adds; null for flat ones.
Json waviness_summary(const std::optional<PhaseStudy> &phases)
{
  if (!phases)
    return nullptr;
  return { { "spin_ripple", phases->spin_ripple },
           { "spin_uncertainty", phases->spin_uncertainty },
           { "zero_of_mean_torque", phases->zero_of_mean_torque },
           { "torque_ripple", phases->torque_ripple },
           { "least_load", phases->least_load },
           { "least_contact_fraction", phases->least_contact_fraction },
           { "glass_phases", phases->n_glass_phases },
           { "table_phases", phases->n_table_phases },
           { "spins", phases->n_spins },
           { "interpolation_error", phases->interpolation_error } };
}

Json coupling_summary(const std::optional<CouplingStatistics> &coupling)
{
  if (!coupling)
    return nullptr;
  return { { "balanced_spins", coupling->n_balances },
           { "contact_solutions", coupling->n_contact_solutions },
           { "response_error", json_number(coupling->response_error) },
           { "interpolation_error", json_number(coupling->interpolation_error) } };
}

Findings findings_of(const Study &study, const ContactReport &report, const SpinStudy &spin,
                     const std::vector<BandedQuantity> &bands, const std::optional<GoalOutcome> &goal)
{
  Findings findings;
  findings.summary = { { "load", load_summary(report.load) },
                       { "load_at_terminal",
                         spin.all().terminal ? load_summary(report.load_at_end) : Json(nullptr) },
                       { "load_at_fall", spin.all().fall ? load_summary(report.load_at_end) : Json(nullptr) },
                       { "contact", report.foot ? json_row(contact_table(*report.foot)) : Json(nullptr) },
                       { "ring", ring_summary(study, report, spin) },
                       { "coupling", coupling_summary(report.coupling) },
                       { "waviness", waviness_summary(spin.phases) },
                       { "budget", spin.is_quick() ? Json(nullptr) : budget_summary(study, spin.budget) },
                       { "without", spin.is_quick() ? Json(nullptr) : without_summary(study, spin.budget) },
                       { "harmonic_effect", harmonic_effect_summary(spin.budget.harmonics) },
                       { "truncation", json_table(truncation_table(spin)) },
                       { "one_ring", spin.one_ring ? json_row(spin_table({ *spin.one_ring })
                                                                .with("", "tau_at_rest omega_terminal "
                                                                          "relative_change"))
                                                   : Json(nullptr) } };
  if (!bands.empty() || spin.is_quick())
    findings.summary["error_bands"] = spin.is_quick() ? Json(nullptr) : band_summary(bands);
  if (study.glass.profile.section)
    findings.summary["profile"] = profile_summary(study, report.load, spin.profile_scatter);
  if (goal)
    findings.summary["goal"] = goal_summary(study, *goal, report.foot.value(), bands);
  findings.key_figures = { { "tau_at_rest", spin.all().at_rest.value().friction.torque },
                           { "omega_terminal", json_number(spin.all().omega_terminal()) },
                           { "omega_terminal_band", json_number(band_of(bands, "omega_terminal")) },
                           { "omega_terminal_first_harmonic",
                             json_number(spin.rows.front().omega_terminal()) },
                           { "harmonic_effect", json_number(spin.budget.harmonics.absolute) },
                           { "harmonic_effect_relative", json_number(spin.budget.harmonics.relative) } };
  if (const auto error = spin_error(spin.profile_scatter))
    findings.key_figures["omega_terminal_profile_error"] = *error;
  return findings;
}

// ---- report

/// How much of the rim carries load in the state that the spin is about; empty for the whole rim, and for a
/// load that the answer has described.
std::string lift_off_remarks(const Study &study, const ContactReport &report, const SpinStudy &spin)
{
  if (spin.all().fall)
    return joined({ lift_off_remark(report.load, "At rest"),
                    lift_off_remark(report.load_at_end, "Where it falls over") });
  if (!is_spin(study, *spin.all().omega_terminal()))
    return lift_off_remark(report.load, "At rest");
  if (is_one_way(study))
    return lift_off_remark(report.load, "At every spin");
  const std::string at_end = lift_off_remark(
    report.load_at_end,
    spin.phases ? "At the terminal spin, with the marks where they are at t = 0," : "At the terminal spin");
  return at_end.empty() ? lift_off_remark(report.load, "At rest") : at_end;
}

std::string title(const Study &study)
{
  switch (study.load.source)
  {
  case LoadSource::contact:
    return "Spin of a wine glass on the load of its elastic foot";
  case LoadSource::first_harmonic:
    return "Spin of a wine glass on a first-harmonic load";
  case LoadSource::file:
    return "Spin of a wine glass on a given load";
  }
  throw std::logic_error("a load source without a title");
}

ReportSection budget_section(const Study &study, const ContactReport &report, const SpinStudy &spin)
{
  const Budget &budget = spin.budget;
  const Table rows = shown_budget_table(study, budget);
  const double rounding = 1e-9 * spin_scale(study);
  ReportSection section = {
    "From the paper's model to this study's",
    joined({ lift_off_remarks(study, report, spin), layer_remark(study, report.load.half_width()),
             waviness_remark(study, spin.phases) }) +
      "\n\nEach row adds one thing to the model of the row above; its difference is what that thing does. "
      "The "
      "harmonics come last: in the rows n ≤ 1, 2, 3 ... the contact has its whole pressure, and friction and "
      "torque are those of the harmonics that are kept. A load is called formal where it is negative "
      "somewhere: the "
      "table would have to pull.",
    {},
    { rows.with("Terminal spin in models of increasing detail",
                "step title omega_terminal difference relative_difference band remark") }
  };
  add_scatter_row(spin.profile_scatter, "title", section.tables.back());
  if (is_spin(study, spin.all().omega_terminal().value_or(0))) // else all bars are rounding
    section.plots = { waterfall_plot(budget, rounding), effects_plot(budget, rounding) };
  if (budget.rows.back().name == "harmonics" && !budget.omega.empty() && !spin.all().fall)
    section.plots.push_back(harmonic_torque_plot(budget));
  if (!budget.without.empty())
    section.tables.push_back(without_table(study, budget)
                               .with("The complete model without one thing at a time",
                                     "name omega_terminal difference relative_difference remark"));
  section.tables.push_back(rows.with("Torque τ_z at rest, at half and at all of this study's terminal spin",
                                     "step title torques[]"));
  return section;
}

ReportSection load_section(const Study &study, const LoadReport &load,
                           const std::vector<BandedQuantity> &bands)
{
  const ring::RingStack &rings = load.rings;
  const std::vector<fem::AzimuthLoad> pointwise = drawn_pointwise(load);
  const double rounding = 1e-12 * load.normal_force * rings.radius();
  const auto moment = [=](double value)
  { return format::significant<6>(std::abs(value) < rounding ? 0 : value); };
  ReportSection section = {
    "The load on the table",
    fmt::format(
      FMT_STRING(
        "Before the glass spins it presses on the table with N = {:.6g} N and the moment M_N = ({}, "
        "{}) N m, a moment ratio m = |M_N| / (N R / 2) of {:.4g}. Above 1 a first-harmonic load would "
        "have to pull, at 2 the glass tips. {:.1f} % of the rim carries load; the least load is "
        "{:.4g} N/rad. {} with the same N, M_N and first harmonic has a radius of {:.6g} m."),
      format::Number{ load.normal_force }, moment(load.moment.x()), moment(load.moment.y()),
      format::Number{ load.moment_ratio }, format::Number{ 100 * load.contact_fraction },
      format::Number{ load.minimum },
      rings.rings().size() > 1
        ? fmt::format(FMT_STRING("The pressure acts on {} rings; one ring"), rings.rings().size())
        : "The ring",
      format::Number{ rings.radius() }),
    { load_plot(rings, pointwise, study.motion.orbit.orbit_sense),
      line_load_plot(rings, study.motion.orbit.orbit_sense) },
    { harmonics_table(rings, spectrum_band(bands, rings.n_harmonics())) }
  };
  if (rings.n_harmonics() > 1)
    section.plots.push_back(higher_harmonics_plot(rings, !pointwise.empty()));
  section.plots.push_back(spectrum_plot(rings, spectrum_band(bands, rings.n_harmonics())));
  return section;
}

/// "Friction's torque and the lean torque add up to zero": what makes a spin the terminal one.
std::string torques_of_balance(const Study &study)
{
  const bool leans = study.tilts(), grips = study.motion.grip_torque > 0;
  if (!leans && !grips)
    return "Friction's torque vanishes";
  const char *others = leans && grips ? ", the lean torque and that of the fingers"
                       : leans        ? " and the lean torque"
                                      : " and that of the fingers";
  return std::string("Friction's torque") + others + " add up to zero";
}

/// Where the spin-up ends, and why.
std::string terminal_spin_clause(const Study &study, const SpinStudy &spin)
{
  const SpinRow &all = spin.all();
  if (all.fall)
    return fmt::format(FMT_STRING("The spin-up ends at {:.3g} rad/s, where the glass falls over."),
                       all.fall->omega);
  const double omega = *all.omega_terminal();
  std::string text =
    fmt::format(FMT_STRING("{}{} at the terminal spin ω = {:.6g} rad/s, which is {:.3g} turns per second"),
                torques_of_balance(study), spin.phases ? ", in the mean over a long time," : "", omega,
                std::abs(omega) / boost::math::double_constants::two_pi);
  if (const auto time_constant = all.time_constant())
    text +=
      "; the glass approaches it with a time constant of " + format::significant<4>(*time_constant) + " s";
  return text + ".";
}

ReportSection spin_section(const Study &study, const ContactReport &report, const SpinStudy &spin)
{
  const SpinRow &all = spin.all();
  const double friction = study.motion.orbit.friction_at_rest();
  const double rounding = 1e-9 * friction * report.load.normal_force * report.load.rings.radius();
  const auto torque = [=](double value)
  { return format::significant<6>(std::abs(value) < rounding ? 0 : value) + " N m"; };
  ReportSection section = { "Torque and spin",
                            "Friction turns the glass at rest with τ_z = " +
                              torque(all.at_rest.value().friction.torque) +
                              "; μ M_Nx, which no harmonic beyond the first can change, is " +
                              torque(friction * report.load.moment.x()) + ".",
                            { torque_plot(spin.torque, spin.rows) },
                            { friction_table(study, all) } };
  if (spin.phases)
    section.plots.push_back(phase_plot(*spin.phases));
  if (!is_spin(study, all.last_spin().value()))
    return section;
  section.text += " " + terminal_spin_clause(study, spin);
  const SpinUpCurves &curves = spin.spin_up;
  std::vector<SpinCurve> spin_ups = { { "all harmonics", curves.adaptive, 1 } };
  if (!curves.first_harmonic.empty())
    spin_ups.push_back({ "first harmonic", curves.first_harmonic, 2 });
  spin_ups.push_back({ "the paper's model", curves.paper, static_cast<unsigned int>(spin_ups.size()) + 1 });
  section.plots.push_back(spin_up_plot(curves.time, spin_ups, all));
  return section;
}

ReportSection truncation_section(const SpinStudy &spin)
{
  return {
    "Fewer harmonics",
    "No harmonic beyond the first changes the torque at rest. The bound on the change of τ_z follows from "
    "the harmonics left out alone, at the terminal spin of all harmonics. Where the least load is "
    "negative, the table would have to pull. Rows that change the spin by less than 1e-9 stand in "
    "truncation.dat only.",
    { truncation_plot(truncation_table(spin)) },
    { shown_truncation_table(spin) }
  };
}

/// The foot in pictures: its section, its rim, and where it presses on the table.
ReportSection foot_section(const Study &study, const FootReport &foot)
{
  FootLengths lengths = measured(foot.section, study.glass.profile.contact_radius);
  if (study.contact.mesh_file.empty())
    lengths.crown_radius = study.glass.profile.crown_radius;
  const fem::ContactWidth band = fem::loaded_band(foot.footprint);
  lengths.load_inner_radius = band.inner;
  lengths.load_outer_radius = band.outer;
  ReportSection section = { "The foot",
                            "",
                            { section_plot(foot.section, lengths), rim_plot(lengths),
                              view_from_below_plot(foot.footprint, lengths, study.motion.orbit) } };
  if (const auto &circle = study.glass.rim_circle; circle && circle->has_scatter())
  {
    section.plots.push_back(rim_circle_plot(*circle));
    section.plots.push_back(rim_residual_plot(*circle));
    section.tables = { rim_table(study) };
  }
  return section;
}

ReportSection contact_section(const Study &study, const FootReport &foot)
{
  Table numbers = contact_table(foot).with(
    "", "body unknowns contact_nodes loaded_nodes nodes_across outcome iterations force_residual "
        "moment_residual equilibrium_residual table_motion[]");
  if (foot.foot.n_cells)
    numbers.columns.insert(numbers.columns.begin() + 1, single(quantity::cells, *foot.foot.n_cells));
  return { "The contact at rest",
           narrow_contact_remark(study, foot),
           { footprint_plot(foot.footprint, study.glass.profile.contact_radius) },
           { as_list(numbers) } };
}

std::vector<ResultFile> files_of(const Study &study, const ContactReport &report, const SpinStudy &spin)
{
  Table truncations = truncation_table(spin);
  truncations["relative_change"].name += ", nan where that is 0";
  std::vector<ResultFile> files = { { "summary.json", "all numbers, for programs" },
                                    { "parameters.prm", "the study, to be run again" },
                                    { "load.dat", "λ(θ) at rest", load_table(report.load.rings) },
                                    { "harmonics.dat", "its Fourier coefficients; Load/File reads them",
                                      load_file_text(report.load.rings) },
                                    { "rings.dat", "the same ring by ring", ring_table(report.load.rings) } };
  if (!spin.is_quick())
    files.push_back(
      { "budget.dat",
        "the terminal spin from the paper's model to this study's, and without one thing at a time",
        budget_file_text(study, spin.budget) });
  files.insert(files.end(),
               { { "torque.dat", "τ_z, T_x, T_y against the spin", torque_table(spin.torque) },
                 { "spin_up.dat", "the spin against time", spin_up_table(spin.spin_up, report.coupling) },
                 { "truncation.dat", "the answer after 1, 2, 3, 4, 6, 8 ... harmonics", truncations } });
  if (spin.spin_up.driven)
    files.push_back({ "driven_spin_up.dat", "the spin against time with the hand's own speeds",
                      driven_spin_table(*spin.spin_up.driven) });
  if (spin.phases)
    files.push_back({ "phases.dat", "τ_z by the orientation of glass and table", phase_table(*spin.phases) });
  if (const auto &foot = report.foot)
  {
    files.push_back({ "load_lines.dat", "λ(θ) at rest where the contact was solved",
                      pointwise_table(report.load.pointwise) });
    files.push_back({ "footprint.dat", "pressure p(r, θ) of the foot on the table at rest",
                      footprint_text(foot->footprint) });
    files.push_back(
      { "contact_history.dat", "Newton steps of the contact", history_table(foot->at_rest.history) });
    for (const fem::FieldFile &file : foot->fields)
      if (file.name == "contact.vtu" || file.name == "contact.pvtu") // and not a piece of the latter
        files.push_back({ "fields/" + file.name, "displacement, stress and contact pressure for ParaView" });
  }
  files.push_back({ "timings.json", "how long it took" });
  return files;
}

Report report_of(const Study &study, const ContactReport &contact, const SpinStudy &spin,
                 const std::vector<BandedQuantity> &bands, const std::vector<ResultFile> &files,
                 const std::optional<GoalOutcome> &goal)
{
  Report report = {
    title(study),
    joined({ run_answer(study, spin, bands),
             profile_remark(study, contact.load, spin.profile_scatter, band_of(bands, "omega_terminal")) }),
    { load_section(study, contact.load, bands), spin_section(study, contact, spin) }
  };
  if (!spin.is_quick())
    report.sections.insert(report.sections.begin(), budget_section(study, contact, spin));
  if (const auto section = terminal_spins_section(spin))
    report.sections.push_back(*section);
  if (spin.spin_up.driven)
    report.sections.push_back(driven_spin_section(spin.spin_up, band_of(bands, "omega_terminal")));
  if (contact.load.rings.n_harmonics() > 1 && spin.spins_up())
    report.sections.push_back(truncation_section(spin));
  if (is_one_way(study))
    say_one_way(report);
  if (contact.foot && !contact.foot->section.empty())
    report.sections.push_back(foot_section(study, *contact.foot));
  if (contact.foot)
    report.sections.push_back(contact_section(study, *contact.foot));
  if (!bands.empty())
    report.sections.push_back(error_band_section(bands));
  if (!bands.empty() && goal)
    report.sections.back().text += goal_sentence(study, *goal, bands);
  add_closing_sections(report, study, files);
  return report;
}

} // namespace

Results tabulate(const Study &study, const ContactReport &report, const SpinStudy &spin,
                 const std::vector<BandedQuantity> &bands, const std::optional<GoalOutcome> &goal)
{
  Results results;
  results.files = files_of(study, report, spin);
  results.report = report_of(study, report, spin, bands, results.files, goal);
  const std::vector<std::string> remarks = { lift_off_remarks(study, report, spin),
                                             narrow_contact_remark(study, report.foot),
                                             layer_remark(study, report.load.half_width()),
                                             waviness_remark(study, spin.phases),
                                             terminal_spins_remark(spin) };
  results.console = { { joined({ results.report.answer, joined(remarks) }) } };
  if (!spin.is_quick())
  {
    Budget steps = spin.budget;
    steps.rows = named_steps(spin.budget.rows);
    results.console.push_back(chain_block(study, steps));
    add_scatter_row(spin.profile_scatter, "console_title", *results.console.back().table);
  }
  results.findings = findings_of(study, report, spin, bands, goal);
  results.fields = own_fields(report).fields;
  return results;
}

Results own_fields(const ContactReport &report)
{
  Results results;
  if (report.foot)
    results.fields = report.foot->fields;
  return results;
}

} // namespace stemware::pipeline
