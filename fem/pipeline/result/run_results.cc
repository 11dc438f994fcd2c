#include "fem/contact/footprint.h"
#include "fem/geometry/section_lengths.h"
#include "fem/pipeline/analysis/quantities_of_interest.h"
#include "fem/pipeline/coupling/contact_report.h"
#include "fem/pipeline/result/common_sections.h"
#include "fem/pipeline/result/curves.h"
#include "fem/pipeline/result/number_format.h"
#include "fem/pipeline/result/results.h"
#include "fem/pipeline/result/sentences.h"
#include "fem/pipeline/result/verb_results.h"

#include <algorithm>
#include <cmath>

namespace stemware::pipeline
{

namespace
{

constexpr double millimetres = 1e3, micrometres = 1e6; ///< per metre

/// Returns the largest of the numbers 1, 1.5, 2, ... 9.5, 10, 15 ... that does not exceed @p factor.
double round_down(double factor)
{
  const double power = std::pow(10, std::floor(std::log10(factor)));
  return std::floor(2 * factor / power) / 2 * power;
}

/// Rounds to a hundredth of a millimetre, less than a pixel in a drawing of the whole foot.
Json drawn(double length)
{
  return rounded_number(std::round(1e2 * length * millimetres) / 1e2);
}

/// Returns the quadrilaterals of a section with magnified displacements and von Mises stresses [MPa].
Json stresses(const std::vector<fem::StressedPatch> &section)
{
  constexpr double share_of_radius = 0.04;
  double edge = 0, move = 0, stress = 0;
  for (const fem::StressedPatch &patch : section)
    for (const auto &row : patch)
      for (const fem::StressedPoint &point : row)
      {
        edge = std::max(edge, std::abs(point.x));
        move = std::max(move, std::hypot(point.displacement_x, point.displacement_z));
        stress = std::max(stress, point.von_mises);
      }
  const double magnification =
    move > 0 ? std::pow(10, std::round(std::log10(share_of_radius * edge / move))) : 1;
  Json x = Json::array(), z = Json::array(), values = Json::array();
  for (const fem::StressedPatch &patch : section)
    for (std::size_t i = 0; i + 1 < patch.size(); ++i)
      for (std::size_t j = 0; j + 1 < patch[i].size(); ++j)
      {
        const fem::StressedPoint *corners[] = { &patch[i][j], &patch[i][j + 1], &patch[i + 1][j + 1],
                                                &patch[i + 1][j] };
        double mean = 0;
        for (const fem::StressedPoint *corner : corners)
        {
          x.push_back(drawn(corner->x + magnification * corner->displacement_x));
          z.push_back(drawn(corner->z + magnification * corner->displacement_z));
          mean += corner->von_mises / 4;
        }
        values.push_back(rounded_number(mean * 1e-6, 3));
      }
  return { { "x", x },
           { "z", z },
           { "stress", values },
           { "largest", rounded_number(stress * 1e-6) },
           { "magnification", magnification },
           { "move", move * micrometres } };
}

/// Returns the cells of a section and its lengths [mm]. @p crown_radius [m]: 0 for a flat or unknown crown.
Json section_of(const std::vector<fem::SectionPolygon> &cells, double contact_radius, double crown_radius,
                const fem::ContactWidth &band)
{
  const fem::SectionLengths lengths = fem::lengths_of(cells, contact_radius);
  Json x = Json::array(), z = Json::array();
  for (const fem::SectionPolygon &cell : cells)
  {
    std::vector<double> radii, heights;
    for (const auto &corner : cell)
    {
      radii.push_back(corner[0] * millimetres);
      heights.push_back(corner[1] * millimetres);
    }
    x.push_back(rounded_number(radii, 5));
    z.push_back(rounded_number(heights, 4));
  }
  return { { "x", x },
           { "z", z },
           { "radius", contact_radius * millimetres },
           { "edge", lengths.outer_radius * millimetres },
           { "top", lengths.height * millimetres },
           { "stem", lengths.stem_radius * millimetres },
           { "thickness", lengths.thickness * millimetres },
           { "crown", crown_radius * millimetres },
           { "inner", band.inner * millimetres },
           { "outer", band.outer * millimetres } };
}

/// Adds the table "foot": pressures, stresses, section and, if known, the rim.
void add_foot_pictures(const StudyAnswer &answer, const FootReport &foot, Results &results)
{
  const auto &[study, goal, contact, spin, bands, budget, fields] = answer;
  constexpr double share_of_radius = 0.12;
  const double radius = study.glass.profile.contact_radius;
  Json &pictures = results.tables["foot"];
  double largest = fem::largest_pressure(foot.footprint);
  if (foot.footprint_at_end)
    largest = std::max(largest, fem::largest_pressure(*foot.footprint_at_end));
  const std::optional<double> band = band_of(bands, "peak_pressure");
  pictures["footprint"] =
    pressure_map(foot.footprint, radius, largest, foot.at_rest.load.peak_pressure, band);
  if (foot.footprint_at_end)
    pictures["footprint_at_end"] =
      pressure_map(*foot.footprint_at_end, radius, largest, foot.at_end->load.peak_pressure, band);
  if (!fields.stressed_section.empty())
    pictures["stresses"] = stresses(fields.stressed_section);
  if (foot.section.empty())
    return;
  const double crown = study.contact.mesh_file.empty() ? study.glass.profile.crown_radius : 0;
  const fem::ContactWidth zone = fem::loaded_band(foot.footprint);
  pictures["section"] = section_of(foot.section, radius, crown, zone);
  // The picture magnifies the radial distance of the footprint from the rim circle.
  const double extent = std::max({ radius - zone.inner, zone.outer - radius, 1e-4 * radius });
  pictures["magnification"] = std::max(1., round_down(share_of_radius * radius / extent));
}

struct FrictionRow
{
  std::string name;
  ring::Torques torques;
  double sum = 0;
};

Table friction_table(const ring::Motion &motion, const ring::Answer &all)
{
  static const auto fields = Fields<FrictionRow>{
    { "name", "", "", &FrictionRow::name, on_page(" ") },
    { "torque", "N m", "", [](const FrictionRow &row) { return row.torques.friction.torque; },
      on_page("τ_z") },
    { "lean_torque", "N m", "", [](const FrictionRow &row) { return row.torques.lean_torque; },
      on_page("lean torque") },
    { "grip_torque", "N m", "", [](const FrictionRow &row) { return row.torques.grip_torque; },
      on_page("torque of the fingers") },
    { "torque_sum", "N m", "", [](const FrictionRow &row) { return row.sum; },
      on_page("sum of the torques") },
    { "force[0]", "N", "", [](const FrictionRow &row) { return row.torques.friction.force_x; },
      on_page("T_x") },
    { "force[1]", "N", "", [](const FrictionRow &row) { return row.torques.friction.force_y; },
      on_page("T_y") }
  };
  const ring::RingStack &load = all.at_rest.value().load;
  const double force = motion.friction_at_rest() * load.normal_force();
  const double torque = force * load.radius();
  std::vector<FrictionRow> rows = { { "at rest", *all.at_rest, all.at_rest->torque() } };
  if (all.fall)
    rows.push_back({ "where it tips", *all.fall, all.fall->torque() });
  else if (all.at_terminal)
    rows.push_back({ "at the terminal spin", *all.at_terminal, all.at_terminal->torque() });
  for (auto &[name, at, sum] : rows)
  {
    for (double *value : { &at.friction.torque, &at.lean_torque, &at.grip_torque })
      *value = without_rounding(*value, 1e-12 * torque);
    for (double *value : { &at.friction.force_x, &at.friction.force_y })
      *value = without_rounding(*value, 1e-12 * force);
    sum = without_rounding(sum, 1e-9 * torque);
  }
  return fields.table(rows, Face::page);
}

Table shown_chain_table(const StudyAnswer &answer, const std::vector<BudgetRow> &rows, Face face)
{
  const std::optional<double> band = rows.empty() ? std::nullopt : rows.back().band;
  const auto shown_spin = [band](double omega) -> Json { return format::spin(omega, band); };
  return chain_fields(answer.study.spin_scale(), shown_spin)
    .table(shown_chain(rows, answer.study.rounding_of_spins()), face);
}

Table without_table(const StudyAnswer &answer, Face face)
{
  const Budget &budget = answer.budget.value();
  std::vector<WithoutRow> rows = budget.without;
  for (WithoutRow &row : rows)
    drop_rounding(row.difference, answer.study.rounding_of_spins());
  return without_fields(budget.rows.back().omega_terminal, answer.study.spin_scale()).table(rows, face);
}

void add_spin(const StudyAnswer &answer, Results &results)
{
  const auto &[study, goal, contact, spin, bands, budget, fields] = answer;
  const ring::Motion &motion = study.motion.orbit;
  const double radius = study.glass.profile.contact_radius;
  add_slip("slip_at_rest", motion, radius, contact.load, 0, results);
  if (const auto omega = spin.answer().omega_terminal(); omega && study.is_spin(*omega))
    add_slip("slip_at_end", motion, radius, contact.load_at_end, *omega, results);
  add_curves(spin, torque_columns(spin.torque), spin_up_columns(spin.spin_up), results);
  if (!spin.spin_up.instants.empty())
    add_motion(motion, radius, spin.spin_up.instants, results);
  if (spin.phases)
  {
    results.words["marked"] = spin.phases->n_glass_phases > 1 ? "glass" : "table";
    results.add_table("phases",
                      phase_columns(*spin.phases).table(points_of(spin.phases->phases.size()), Face::picture),
                      Face::picture);
  }
  results.add_table("friction", friction_table(motion, spin.answer()));
  add_truncations(answer, results);
}

void add_budget(const StudyAnswer &answer, Results &results)
{
  const Budget &budget = answer.budget.value();
  const std::vector<BudgetRow> &rows = budget.rows;
  results.add_table("chain", shown_chain_table(answer, rows, Face::page));
  results.add_table("chain_torques", chain_torque_fields().table(
                                       shown_chain(rows, answer.study.rounding_of_spins()), Face::page));
  results.tables["waterfall"] = chain_fields().json(named_steps(rows));
  if (!budget.without.empty())
    results.add_table("without", without_table(answer, Face::page));
}

std::vector<std::variant<std::string, Table>> console_of(const StudyAnswer &answer, const Json &words)
{
  std::string text;
  for (const char *part :
       { "answer", "lift_off", "pressed", "narrow_contact", "thin_layer", "out_of_flat", "several_spins" })
    append(text, words[part]);
  if (!answer.budget)
    return { text };
  std::vector<std::variant<std::string, Table>> parts = {
    text, "From the paper's model to this study's:",
    shown_chain_table(answer, named_steps(answer.budget->rows), Face::console)
  };
  if (!answer.budget->without.empty())
    parts.insert(parts.end(), { "The complete model without one effect at a time:",
                                without_table(answer, Face::console) });
  return parts;
}

} // namespace

Results run_results(const StudyAnswer &answer)
{
  const auto &[study, goal, contact, spin, bands, budget, fields] = answer;
  const HarmonicEffect effect = harmonic_effect(spin.rows);
  Results results = begun_results(study, "how fast it spins");
  results.summary = run_fields().json(answer);
  results.key_figures = { { "tau_at_rest", spin.answer().at_rest.value().friction.torque },
                          { "omega_terminal", spin.answer().omega_terminal() },
                          { "omega_terminal_band", band_of(bands, "omega_terminal") },
                          { "omega_terminal_first_harmonic", spin.rows.omega_first_harmonic() },
                          { "harmonic_effect", effect.absolute },
                          { "harmonic_effect_relative", effect.relative } };
  results.words.update(run_words(answer));
  add_spin(answer, results);
  if (budget)
    add_budget(answer, results);
  add_load_lines(contact.load, results);
  if (contact.foot)
  {
    add_foot_pictures(answer, *contact.foot, results);
    results.add_table("contact", as_list(contact_fields().table({ *contact.foot }, Face::page)));
  }
  if (!bands.empty())
    add_band_tables(bands, results);
  results.files = run_files(answer);
  results.console = console_of(answer, results.words);
  return results;
}

} // namespace stemware::pipeline
