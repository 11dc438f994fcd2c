#include "fem/pipeline/report/run_results.h"

#include "fem/pipeline/report/budget_tables.h"
#include "fem/pipeline/report/common_sections.h"
#include "fem/pipeline/report/driven_spin.h"
#include "fem/pipeline/report/facts.h"
#include "fem/pipeline/report/goal_results.h"
#include "fem/pipeline/report/head.h"
#include "fem/pipeline/report/plots/plots.h"
#include "fem/pipeline/report/profile_results.h"
#include "fem/pipeline/report/quantities.h"
#include "fem/pipeline/report/render/table_renderers.h"
#include "fem/pipeline/report/run_facts.h"
#include "fem/pipeline/report/run_tables.h"
#include "fem/pipeline/report/spin_table.h"
#include "fem/pipeline/report/terminal_spins.h"
#include "fem/pipeline/study/measured_spin_file.h"

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

/// A value of ring_state() at the row's terminal spin; null where it has none.
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

/// The points that are drawn beside the spin-up.
std::vector<MeasuredSpin> measured_spins(const Study &study)
{
  const std::string &file = study.motion.measured_spin_file;
  return file.empty() ? std::vector<MeasuredSpin>() : read_measured_spin_file(file);
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
           { "measured", study.motion.measured_spin_file.empty()
                           ? Json(nullptr)
                           : Json{ { "points", measured_spins(study).size() } } },
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

/// Summary of the effects of an out-of-flat rim or table; null for flat ones.
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
           { "contacts",
             { { "answer", coupling->contacts.answer },
               { "curves", coupling->contacts.curves },
               { "budget", coupling->contacts.budget },
               { "bands", coupling->contacts.bands } } },
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

/// The contact at rest for people.
Table contact_list(const FootReport &foot)
{
  Table numbers = contact_table(foot).with(
    "", "body unknowns contact_nodes loaded_nodes nodes_across outcome iterations force_residual "
        "moment_residual equilibrium_residual table_motion[]");
  if (foot.foot.n_cells)
    numbers.columns.insert(numbers.columns.begin() + 1, single(quantity::cells, *foot.foot.n_cells));
  return as_list(numbers);
}

void add_foot(const Study &study, const FootReport &foot, Document &document)
{
  document.tables["contact"] = contact_list(foot);
  document.tables["contact_history"] = history_table(foot.at_rest.history);
  document.tables["footprint"] = footprint_table(foot.footprint);
  if (foot.footprint_at_end)
    document.tables["footprint_at_end"] = footprint_table(*foot.footprint_at_end);
  if (const auto &circle = study.glass.rim_circle; !foot.section.empty() && circle && circle->has_scatter())
    document.tables["rim"] = rim_table(study);
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
  document.plots["truncation"] = { { "bound_scale", nullptr }, { "rounding", 1e-12 } };
  auto &tables = document.tables;
  tables["friction"] = friction_table(study, spin.all());
  tables["torque"] = torque_table(spin.torque);
  tables["spin_up"] = spin_up_table(spin.spin_up, report.coupling);
  tables["terminal_spins"] = terminal_spins_table(spin);
  tables["shown_truncations"] = shown_truncation_table(spin);
  tables["truncations"] = truncation_table(spin);
  tables["truncations"]["relative_change"].name += ", nan where that is 0";
  if (spin.spin_up.driven)
    tables["driven"] = driven_spin_table(*spin.spin_up.driven);
  if (spin.phases)
    tables["phases"] = phase_table(*spin.phases);
}

void add_budget(const Study &study, const SpinStudy &spin, Document &document)
{
  add_chain(study, spin.budget, document);
  document.tables["scattered_chain"] = document.tables["chain"];
  add_scatter_row(spin.profile_scatter, "title", document.tables["scattered_chain"]);
  document.tables["scattered_steps"] = document.tables["named_steps"];
  add_scatter_row(spin.profile_scatter, "console_title", document.tables["scattered_steps"]);
  document.tables["without"] = without_table(study, spin.budget);
  document.tables["without"]["reason"].name = "why there is none";
  document.tables["budget"] = budget_table(study, spin.budget);
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
  add_head(study, turning_glasses(report, spin), document, report.load.rings);
  add_spin(study, report, spin, document);
  if (!spin.is_quick())
    add_budget(study, spin, document);
  add_load(study, report.load, bands, document);
  if (report.foot)
    add_foot(study, *report.foot, document);
  add_bands(bands, document);
  add_study(study, document);
  document.fields = own_fields(report).fields;
  return shown(document, "run");
}

Results own_fields(const ContactReport &report)
{
  Results results;
  if (report.foot)
    results.fields = report.foot->fields;
  return results;
}

} // namespace stemware::pipeline
