#include "fem/pipeline/report/run_results.h"

#include "fem/pipeline/report/budget_tables.h"
#include "fem/pipeline/report/common_sections.h"
#include "fem/pipeline/report/driven_spin.h"
#include "fem/pipeline/report/facts.h"
#include "fem/pipeline/report/goal_results.h"
#include "fem/pipeline/report/plots/foot_plots.h"
#include "fem/pipeline/report/plots/plots.h"
#include "fem/pipeline/report/profile_results.h"
#include "fem/pipeline/report/quantities.h"
#include "fem/pipeline/report/render/table_renderers.h"
#include "fem/pipeline/report/run_tables.h"
#include "fem/pipeline/report/spin_table.h"
#include "fem/pipeline/report/terminal_spins.h"
#include "fem/pipeline/support/text.h"

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

// ---- what templates show

/// The row whose step is the largest, those of the harmonics left out; null where none of them is a spin.
const BudgetRow *largest_other_step(const Study &study, const Budget &budget)
{
  const BudgetRow *largest = nullptr;
  for (const BudgetRow &row : budget.rows)
    if (row.name != "harmonics" && row.difference && is_spin(study, *row.difference) &&
        (!largest || std::abs(*row.difference) > std::abs(*largest->difference)))
      largest = &row;
  return largest;
}

Json largest_step_facts(const Study &study, const Budget &budget)
{
  const BudgetRow *row = largest_other_step(study, budget);
  if (!row)
    return nullptr;
  const std::optional<double> relative =
    relative_to(*row->omega_terminal - *row->difference, row->difference, spin_scale(study));
  return { { "name", row->name },
           { "difference", *row->difference },
           { "change", relative ? faster_or_slower(*relative) : "" },
           { "formal", row->standing == Standing::formal } };
}

/// The paper's answer, to stand beside the study's; null where the study is the paper's model.
Json paper_facts(const Study &study, const Budget &budget)
{
  if (budget.rows.size() < 2 || !budget.rows.front().omega_terminal)
    return nullptr;
  const double omega = *budget.rows.front().omega_terminal;
  Json facts = spin_facts(study, omega);
  facts["spins"] = is_spin(study, omega);
  return facts;
}

/// "tilt +0.16, grip 0": what the terminal spin changes by without one thing at a time [rad/s].
std::string left_out(const Study &study, const Budget &budget)
{
  std::vector<std::string> parts;
  for (const WithoutRow &row : budget.without)
    if (row.difference)
      parts.push_back(row.name + " " +
                      format::signed_significant<2>(is_spin(study, *row.difference) ? *row.difference : 0));
  return parts.empty() ? "" : listed(parts, "and");
}

/// How the glass ends: falling, held, stays or spinning, one of which is there.
void add_end(const Study &study, const SpinStudy &spin, const std::vector<BandedQuantity> &bands, Json &facts)
{
  const SpinRow &all = spin.all();
  const double omega = all.fall ? all.fall->omega : all.omega_terminal().value();
  const bool is_spinning = !all.fall && is_spin(study, omega);
  const std::string held = all.fall || is_spinning ? "" : held_by_the_grip(study, all);
  const std::optional<double> band = band_of(bands, "omega_terminal"),
                              error = spin_error(spin.profile_scatter);
  const bool leans = study.tilts(), grips = study.motion.grip_torque > 0;
  facts.update(
    { { "falling", all.fall ? spin_facts(study, omega) : Json(nullptr) },
      { "spinning", is_spinning ? spin_facts(study, omega) : Json(nullptr) },
      { "held", held },
      { "stays", !all.fall && !is_spinning && held.empty() },
      { "moves", is_spin(study, all.last_spin().value()) },
      { "complete_spins", is_spin(study, all.omega_terminal().value_or(0)) },
      { "moment_ratio_at_rest", all.at_rest.value().moment_ratio },
      { "with_band", with_band(omega, band) },
      { "profile_is_wider", error && *error > band.value_or(0) },
      { "with_error", error ? with_error(omega, *error) : "" },
      { "has_band", band.has_value() },
      { "lacks_band", !band && !spin.is_quick() && study.load.is_from_contact() },
      { "may_be_narrow", study.table.is_hard() && !abilities(study.contact.body).is_of_revolution },
      { "time_constant", json_number(all.time_constant()) },
      { "others", leans && grips ? ", the lean torque and that of the fingers"
                  : leans        ? "and the lean torque"
                  : grips        ? "and that of the fingers"
                                 : "" } });
}

/// The state that the spin is about, and that of rest where nothing is to say of it.
Json lift_offs(const Study &study, const ContactReport &report, const SpinStudy &spin)
{
  if (spin.all().fall)
    return lift_off_facts({ { "At rest", &report.load }, { "Where it falls over", &report.load_at_end } });
  if (is_spin(study, *spin.all().omega_terminal()))
  {
    if (is_one_way(study))
      return lift_off_facts({ { "At every spin", &report.load } });
    const char *at_end =
      spin.phases ? "At the terminal spin, with the marks where they are at t = 0," : "At the terminal spin";
    if (const Json facts = lift_off_facts({ { at_end, &report.load_at_end } }); !facts.empty())
      return facts;
  }
  return lift_off_facts({ { "At rest", &report.load } });
}

Json load_facts(const Study &study, const LoadReport &load, const SpinRow &all)
{
  const double friction = study.motion.orbit.friction_at_rest();
  const double moment = load.normal_force * load.rings.radius();
  const auto without_rounding = [](double value, double rounding)
  { return std::abs(value) < rounding ? 0 : value; };
  const std::size_t n_rings = load.rings.rings().size();
  return { { "moment_x", without_rounding(load.moment.x(), 1e-12 * moment) },
           { "moment_y", without_rounding(load.moment.y(), 1e-12 * moment) },
           { "torque_at_rest",
             without_rounding(all.at_rest.value().friction.torque, 1e-9 * friction * moment) },
           { "closed_form", without_rounding(friction * load.moment.x(), 1e-9 * friction * moment) },
           { "n_rings", n_rings > 1 ? Json(n_rings) : Json(nullptr) },
           { "has_higher_harmonics", load.rings.n_harmonics() > 1 } };
}

Json thin_layer_facts(const Study &study, double half_width)
{
  const double layer = study.table.layer_thickness;
  if (study.table.interface != TableInterface::winkler || !(layer > 0) || !(half_width > 0) ||
      half_width >= layer)
    return nullptr;
  return { { "width", 2 * half_width }, { "thickness", layer } };
}

Json narrow_contact_facts(const Study &study, const std::optional<FootReport> &foot)
{
  if (!foot || foot->at_rest.solution.outcome != fem::ContactOutcome::narrow_contact)
    return nullptr;
  return { { "nodes", foot->at_rest.solution.n_nodes_across }, { "hard", study.table.is_hard() } };
}

Json driven_facts(const SpinUpCurves &curves, const std::optional<double> &band)
{
  if (!curves.driven)
    return nullptr;
  const auto [slowest, fastest] =
    std::minmax_element(curves.driven->speed.begin(), curves.driven->speed.end());
  return { { "slowest", *slowest },
           { "fastest", *fastest },
           { "omega_at_constant_speed", curves.adaptive.back() },
           { "band", band ? format::band(*band) : "" },
           { "file_matters_more", band && curves.driven->interpolation_change > *band } };
}

Json several_spins_facts(const SpinStudy &spin)
{
  const auto &spins = spin.terminal_spins;
  if (spins.size() < 2)
    return nullptr;
  return { { "n", spins.size() },
           { "n_stable", std::count_if(spins.begin(), spins.end(),
                                       [](const ring::TerminalSpin &one) { return one.stable; }) } };
}

const char *kind_of_load(LoadSource source)
{
  switch (source)
  {
  case LoadSource::contact:
    return "the load of its elastic foot";
  case LoadSource::first_harmonic:
    return "a first-harmonic load";
  case LoadSource::file:
    return "a given load";
  }
  throw std::logic_error("a load source without a name");
}

Json facts_of(const Study &study, const ContactReport &report, const SpinStudy &spin,
              const std::vector<BandedQuantity> &bands, const std::optional<GoalOutcome> &goal)
{
  const std::optional<double> band = band_of(bands, "omega_terminal");
  const Budget &budget = spin.budget;
  Json facts = study_facts(study);
  add_end(study, spin, bands, facts);
  facts.update(load_facts(study, report.load, spin.all()));
  Json fields = Json::array();
  if (report.foot)
    for (const fem::FieldFile &file : report.foot->fields)
      if (file.name == "contact.vtu" || file.name == "contact.pvtu") // and not a piece of the latter
        fields.push_back(file.name);
  const bool rim = !study.glass.waviness.empty(), table = !study.table.waviness.empty();
  facts.update(
    { { "quick", spin.is_quick() },
      { "kind_of_load", kind_of_load(study.load.source) },
      { "paper", paper_facts(study, budget) },
      { "effect", spin.rows.size() > 1 ? effect_facts(study, budget.harmonics) : Json(nullptr) },
      { "largest_step", largest_step_facts(study, budget) },
      { "left_out", left_out(study, budget) },
      { "scattered_profile", profile_facts(study, report.load, spin.profile_scatter, band) },
      { "lift_off", lift_offs(study, report, spin) },
      { "thin_layer", thin_layer_facts(study, report.load.half_width()) },
      { "narrow_contact", narrow_contact_facts(study, report.foot) },
      { "what_is_wavy", rim && table ? "Rim and table are" : (table ? "The table is" : "The rim is") },
      { "several_spins", several_spins_facts(spin) },
      { "driven", driven_facts(spin.spin_up, band) },
      { "has_harmonic_torque", !spin.is_quick() && budget.rows.back().name == "harmonics" &&
                                 !budget.omega.empty() && !spin.all().fall },
      { "has_without", !budget.without.empty() },
      { "has_truncations", report.load.rings.n_harmonics() > 1 && spin.spins_up() },
      { "has_section", report.foot && !report.foot->section.empty() },
      { "has_bands", !bands.empty() },
      { "mesh_for_goal", goal && band_of_mesh(study, bands) },
      { "fields", fields } });
  return facts;
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
  document.texts["footprint"] = footprint_text(foot.footprint);
  const double radius = study.glass.profile.contact_radius;
  document.plots["footprint"] = [&foot, radius] { return footprint_plot(foot.footprint, radius); };
  if (foot.section.empty())
    return;
  FootLengths lengths = measured(foot.section, radius);
  if (study.contact.mesh_file.empty())
    lengths.crown_radius = study.glass.profile.crown_radius;
  const fem::ContactWidth band = fem::loaded_band(foot.footprint);
  lengths.load_inner_radius = band.inner;
  lengths.load_outer_radius = band.outer;
  document.plots["section"] = [&foot, lengths] { return section_plot(foot.section, lengths); };
  document.plots["rim"] = [lengths] { return rim_plot(lengths); };
  document.plots["foot_from_below"] = [&foot, &study, lengths]
  { return view_from_below_plot(foot.footprint, lengths, study.motion.orbit); };
  if (const auto &circle = study.glass.rim_circle; circle && circle->has_scatter())
  {
    document.plots["rim_circle"] = [&] { return rim_circle_plot(*circle); };
    document.plots["rim_residuals"] = [&] { return rim_residual_plot(*circle); };
    document.tables["rim"] = rim_table(study);
  }
}

/// omega(t) as the report draws it.
Plot spin_up_of(const SpinStudy &spin)
{
  const SpinUpCurves &curves = spin.spin_up;
  std::vector<SpinCurve> spin_ups = { { "all harmonics", curves.adaptive, 1 } };
  if (!curves.first_harmonic.empty())
    spin_ups.push_back({ "first harmonic", curves.first_harmonic, 2 });
  spin_ups.push_back({ "the paper's model", curves.paper, static_cast<unsigned int>(spin_ups.size()) + 1 });
  return spin_up_plot(curves.time, spin_ups, spin.all());
}

void add_spin(const Study &study, const ContactReport &report, const SpinStudy &spin, Document &document)
{
  auto &plots = document.plots;
  plots["torque"] = [&] { return torque_plot(spin.torque, spin.rows); };
  plots["phases"] = [&] { return phase_plot(spin.phases.value()); };
  plots["spin_up"] = [&] { return spin_up_of(spin); };
  plots["driven_spin_up"] = [] { return plot_from("driven_spin_up"); };
  plots["orbit_speed"] = [] { return plot_from("orbit_speed"); };
  plots["truncation"] = [&] { return truncation_plot(truncation_table(spin)); };
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
  document.texts["budget"] = budget_file_text(study, spin.budget);
}

} // namespace

Results tabulate(const Study &study, const ContactReport &report, const SpinStudy &spin,
                 const std::vector<BandedQuantity> &bands, const std::optional<GoalOutcome> &goal)
{
  Document document = { findings_of(study, report, spin, bands, goal),
                        facts_of(study, report, spin, bands, goal) };
  add_spin(study, report, spin, document);
  if (!spin.is_quick())
    add_budget(study, spin, document);
  if (is_one_way(study))
    say_one_way(document);
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
