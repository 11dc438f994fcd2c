#include "fem/pipeline/document/spin_rows.h"
#include "fem/pipeline/document/table.h"
#include "fem/pipeline/report/common_sections.h"
#include "fem/pipeline/report/run_results.h"

#include <algorithm>
#include <cmath>

namespace stemware::pipeline
{

using Json = nlohmann::ordered_json;

namespace
{

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

/// How the glass ends: falling, held, stays or spinning, one of which is there.
void add_end(const Study &study, const SpinStudy &spin, const std::vector<BandedQuantity> &bands, Json &facts)
{
  const SpinRow &all = spin.all();
  const double omega = all.fall ? all.fall->omega : all.omega_terminal().value();
  const bool is_spinning = !all.fall && is_spin(study, omega);
  const std::string held = all.fall || is_spinning ? "" : held_by_the_grip(study, all);
  const std::optional<double> band = band_of(bands, "omega_terminal");
  const bool leans = study.tilts(), grips = study.motion.grip_torque > 0;
  facts.update(
    { { "falling", all.fall ? spin_facts(study, omega) : Json(nullptr) },
      { "spinning", is_spinning ? spin_facts(study, omega) : Json(nullptr) },
      { "held", held },
      { "stays", !all.fall && !is_spinning && held.empty() },
      { "unstable_rest", all.terminal && !all.terminal->stable },
      { "omega_end", all.last_spin().value_or(0) },
      { "moves", is_spin(study, all.last_spin().value()) },
      { "complete_spins", is_spin(study, all.omega_terminal().value_or(0)) },
      { "moment_ratio_at_rest", all.at_rest.value().moment_ratio },
      { "with_band", format::with_band(omega, band) },
      { "has_band", band.has_value() },
      { "lacks_band", !band && !spin.is_quick() && study.load.is_from_contact() },
      { "may_be_narrow", study.table.is_hard() && !abilities(study.contact.body).is_of_revolution },
      { "time_constant", all.time_constant() },
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
  const std::size_t n_rings = load.rings.rings().size();
  const bool has_second = load.rings.n_harmonics() > 1;
  Json facts = Json::array(
    { { { "moment_x", load.moment.x() },
        { "moment_y", load.moment.y() },
        { "torque_at_rest", all.at_rest.value().friction.torque },
        { "closed_form", friction * load.moment.x() },
        { "line_load", load.rings.a(0) / load.rings.radius() },
        { "second_harmonic",
          has_second ? Json(std::hypot(load.rings.a(2), load.rings.b(2)) / load.rings.a(0)) : Json(nullptr) },
        { "contact_width", 2 * load.half_width() },
        { "n_rings", n_rings > 1 ? Json(n_rings) : Json(nullptr) } } });
  leave_out_rounding(facts, "moment_x moment_y", 1e-12 * moment);
  leave_out_rounding(facts, "torque_at_rest closed_form", 1e-9 * friction * moment);
  return facts[0];
}

/// How hard and how wide the foot is in contact; null without a contact.
Json pressed_facts(const LoadReport &load)
{
  return load.peak_pressure ? Json{ { "pressure", *load.peak_pressure }, { "width", load.contact_width } }
                            : Json(nullptr);
}

Json thin_layer_facts(const Study &study, double half_width)
{
  const double layer = study.table.layer_thickness;
  if (study.table.interface != TableInterface::winkler || !(layer > 0) || !(half_width > 0) ||
      half_width >= layer)
    return nullptr;
  return { { "width", 2 * half_width }, { "thickness", layer } };
}

/// Null unless the points that the rim follows from have a scatter, above the rounding of numbers in a file.
Json profile_facts(const Study &study)
{
  constexpr double rounding = 1e-9; // m
  const auto &circle = study.glass.rim_circle;
  return circle && circle->rms_distance > rounding ? Json{ { "rms", circle->rms_distance } } : Json(nullptr);
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
           { "band", band },
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

} // namespace

std::optional<double> band_of_mesh(const Study &study, const ErrorBands &bands)
{
  const auto banded = find_quantity(bands, key_of(study.contact.goal));
  if (banded == bands.end() || banded->parts.count("mesh") == 0)
    return std::nullopt;
  return banded->parts.at("mesh");
}

Json run_facts(const Study &study, const ContactReport &report, const SpinStudy &spin,
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
    {
      if (file.name == "contact.vtu" || file.name == "contact.pvtu") // and not a piece of the latter
        fields.push_back({ { "name", file.name }, { "state", "at rest" } });
      if (file.name.find("_at_terminal_spin") != std::string::npos)
        fields.push_back({ { "name", file.name }, { "state", "at the terminal spin" } });
    }
  const bool rim = !study.glass.waviness.empty(), table = !study.table.waviness.empty();
  facts.update(
    { { "quick", spin.is_quick() },
      { "paper", paper_facts(study, budget) },
      { "effect", spin.rows.size() > 1 ? effect_facts(study, budget.harmonics) : Json(nullptr) },
      { "largest_step", largest_step_facts(study, budget) },
      { "scattered_profile", profile_facts(study) },
      { "lift_off", lift_offs(study, report, spin) },
      { "pressed_at_rest", pressed_facts(report.load) },
      { "pressed_at_terminal", spin.all().terminal ? pressed_facts(report.load_at_end) : Json(nullptr) },
      { "thin_layer", thin_layer_facts(study, report.load.half_width()) },
      { "narrow_contact", narrow_contact_facts(study, report.foot) },
      { "why_it_swings", rim && table ? "Rim and table are out of flat"
                         : table      ? "The table is out of flat"
                         : rim        ? "The rim is out of flat"
                                      : "The foot is not round" },
      { "several_spins", several_spins_facts(spin) },
      { "driven", driven_facts(spin.spin_up, band) },
      { "has_harmonic_torque", !spin.is_quick() && budget.rows.back().name == "harmonics" &&
                                 !budget.omega.empty() && !spin.all().fall },
      { "has_truncations", report.load.rings.n_harmonics() > 1 && spin.spins_up() },
      { "has_footprint_at_end", report.foot && report.foot->footprint_at_end && spin.all().terminal },
      { "has_stresses", report.foot && !report.foot->stressed_section.empty() },
      { "has_section", report.foot && !report.foot->section.empty() },
      { "has_bands", !bands.empty() },
      { "mesh_for_goal", goal && band_of_mesh(study, bands) },
      { "fields", fields } });
  return facts;
}

} // namespace stemware::pipeline
