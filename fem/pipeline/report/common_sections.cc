#include "fem/pipeline/report/common_sections.h"

#include "fem/pipeline/analysis/study_rows.h"
#include "fem/pipeline/document/spin_rows.h"
#include "fem/pipeline/report/plots/plots.h"

#include <boost/algorithm/string/replace.hpp>
#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace stemware::pipeline
{

namespace
{

using Json = nlohmann::ordered_json;

/// The parts of an error band in BandedQuantity::parts and in summary.json, in the order in which they are
/// shown.
constexpr const char *band_parts[] = { "mesh",           "degree", "harmonics",     "lines", "interface",
                                       "load_harmonics", "rings",  "interpolation", "solver" };

/// A part of the band; nothing where it was not estimated.
std::optional<double> part_of(const BandedQuantity &quantity, const std::string &key)
{
  const auto part = quantity.parts.find(key);
  return part == quantity.parts.end() ? std::nullopt : std::optional(part->second);
}

/// Parts of error bands: a row for each band, with each part that one of them has.
Json part_rows(const std::vector<BandedQuantity> &bands)
{
  Json rows = Json::array();
  for (const BandedQuantity &each : bands)
  {
    rows.push_back({ { "quantity", each.quantity.name } });
    for (const char *part : band_parts)
      if (std::any_of(bands.begin(), bands.end(),
                      [&](const BandedQuantity &any) { return any.parts.count(part) > 0; }))
        rows.back()[boost::replace_all_copy(std::string(part), "_", " ")] = part_of(each, part);
  }
  return rows;
}

/// The load where it was solved, to be drawn instead of a series that overshoots; nothing without lift-off.
std::vector<fem::AzimuthLoad> drawn_pointwise(const LoadReport &load)
{
  return load.contact_fraction < 1 ? load.pointwise : std::vector<fem::AzimuthLoad>();
}

/// Bands of the amplitudes sqrt(a_n^2 + b_n^2) / a_0, n = 0 ... @p n_harmonics, as harmonic_rows() and
/// add_load_plots() take them: 0 beyond the harmonics that are followed; empty without bands.
std::vector<double> spectrum_band(const ErrorBands &bands, unsigned int n_harmonics)
{
  if (bands.empty())
    return {};
  std::vector<double> widths(n_harmonics + 1, 0);
  for (unsigned int n = 1; n <= std::min(n_harmonics, n_harmonics_of_interest); ++n)
    widths[n] = std::hypot(band_of(bands, "a" + std::to_string(n)).value(),
                           band_of(bands, "b" + std::to_string(n)).value());
  return widths;
}

/// The first harmonics of a load over its mean, for people; those that are smaller than their error band
/// @p band, by n as in add_load_plots(), are left out.
Json harmonic_rows(const ring::RingStack &load, const std::vector<double> &band)
{
  constexpr double rounding = 1e-12;
  Json rows = Json::array();
  for (unsigned int n = 1; n <= std::min(load.n_harmonics(), 8u); ++n)
  {
    const double amplitude = std::hypot(load.a(n), load.b(n)) / load.a(0);
    if (!band.empty() && band.at(n) > amplitude)
      continue;
    // Where a cos n theta + b sin n theta is largest, to a tenth, without the minus of a rounded zero.
    const double crest = std::atan2(load.b(n), load.a(n)) / n / boost::math::double_constants::degree;
    rows.push_back(
      { { "n", n },
        { "a", load.a(n) / load.a(0) },
        { "b", load.b(n) / load.a(0) },
        { "amplitude", amplitude },
        { "crest", amplitude > rounding ? Json(std::round(10 * crest) / 10 + 0.) : Json(nullptr) } });
  }
  leave_out_rounding(rows, "a b amplitude", rounding);
  return rows;
}

/// Steps of the model, then what is left out, one at a time.
Json effect_rows(const std::vector<BudgetRow> &steps, const std::vector<WithoutRow> &without)
{
  Json rows = Json::array();
  for (std::size_t i = 1; i < steps.size(); ++i)
    rows.push_back({ { "row", steps[i].name },
                     { "difference", steps[i].difference },
                     { "is_step", true },
                     { "is_defined", true } });
  for (const WithoutRow &row : without)
    rows.push_back({ { "row", "without " + row.name },
                     { "difference", row.difference },
                     { "is_step", false },
                     { "is_defined", row.reason != "not defined" } });
  return rows;
}

/// The steps between the paper's model and this study's, which have no difference.
Json waterfall_rows(std::vector<BudgetRow> steps)
{
  if (!steps.empty())
  {
    steps.push_back(steps.back());
    steps.back().name = "this study";
    steps.back().standing = Standing::no_balance; // whose row says whether it is formal
    steps.front().name = "the paper's model";
    steps.front().difference = steps.back().difference = std::nullopt;
  }
  Json rows = Json::array();
  for (const BudgetRow &row : steps)
  {
    const bool is_formal = row.standing == Standing::formal;
    rows.push_back({ { "row", row.name + (is_formal ? " (formal)" : "") },
                     { "omega_terminal", row.omega_terminal },
                     { "difference", row.difference },
                     { "band", row.band },
                     { "formal", is_formal } });
  }
  return rows;
}

} // namespace

bool is_one_way(const Study &study)
{
  return study.load.source == LoadSource::file || study.load.is_static() ||
         (study.load.is_from_contact() && study.load.coupling == LoadCoupling::one_way);
}

Json study_facts(const Study &study)
{
  return { { "one_way", is_one_way(study) },
           { "given_load", study.load.source == LoadSource::file },
           { "given_moment", study.load.is_static() } };
}

Json spin_facts(const Study &study, double omega)
{
  constexpr double turn = boost::math::double_constants::two_pi;
  const bool is_with_orbit = omega * study.motion.orbit.sense_sign() > 0;
  return { { "omega", omega },
           { "size", std::abs(omega) },
           { "sense", std::string(omega < 0 ? "clockwise, " : "counter-clockwise, ") +
                        (is_with_orbit ? "with" : "against") + " its orbit" },
           { "seconds_a_turn", turn / std::abs(omega) },
           { "turns_a_second", std::abs(omega) / turn } };
}

Json effect_facts(const Study &study, const HarmonicEffect &effect)
{
  if (!effect.absolute)
    return nullptr;
  return { { "absolute", *effect.absolute },
           { "relative", effect.relative ? faster_or_slower(*effect.relative) : "" },
           { "is_small", !is_spin(study, *effect.absolute) },
           { "rounding", rounding_of_spins(study) } };
}

Json lift_off_facts(const std::vector<std::pair<std::string, const LoadReport *>> &states)
{
  Json facts = Json::array();
  for (const auto &[state, load] : states)
    if (load->minimum < 0 || load->contact_fraction < 1)
      facts.push_back({ { "state", state },
                        { "least", load->minimum },
                        { "share", load->contact_fraction },
                        { "moment_ratio", load->moment_ratio },
                        { "pulls", load->minimum < 0 },
                        { "above_one", load->moment_ratio > 1 } });
  return facts;
}

std::string faster_or_slower(double change)
{
  return format::number(std::abs(change), ".3g%") + (change > 0 ? " faster" : " slower");
}

void add_chain(const Study &study, const Budget &budget, Document &document)
{
  const std::vector<BudgetRow> steps = named_steps(budget.rows);
  const double rounding = rounding_of_spins(study);
  document.facts["chain"] = { { "rows", chain_rows(study, budget.rows) },
                              { "shown", shown_chain(study, budget.rows) },
                              { "steps", shown_chain(study, steps) } };
  document.facts["effects"] = effect_rows(steps, budget.without);
  document.facts["waterfall"] = waterfall_rows(steps);
  document.tables["harmonic_torque"] = { "Torque of friction against the spin",
                                         { numbers("omega", "rad/s", budget.omega),
                                           numbers("tau_z, all harmonics", "N m", budget.torque_all),
                                           numbers("tau_z, first harmonic", "N m", budget.torque_first) } };
  document.plots["waterfall"] = { { "rounding", rounding } };
  const double band = budget.rows.empty() ? 0 : budget.rows.back().band.value_or(0);
  document.plots["effects"] = { { "rounding", rounding }, { "band", band } };
}

void add_load(const Study &study, const LoadReport &load, const std::vector<BandedQuantity> &bands,
              Document &document)
{
  const std::vector<double> band = spectrum_band(bands, load.rings.n_harmonics());
  add_load_plots(load.rings, drawn_pointwise(load), band, study.motion.orbit.orbit_sense, document);
  document.facts["load_harmonics"] = harmonic_rows(load.rings, band);
  document.facts["mean_load"] = load.rings.a(0);
  document.tables["load"] = load_table(load.rings);
  document.tables["rings"] = ring_table(load.rings);
  document.tables["load_lines"] = pointwise_table(load.pointwise);
  document.texts["harmonics"] = load_file_text(load.rings);
}

void add_truncations(const std::vector<SpinRow> &rows, const std::optional<SpinRow> &one_ring,
                     Document &document)
{
  const auto changes_by = [](double change)
  {
    return [=](const SpinRow &row) { return row.relative_change && std::abs(*row.relative_change) > change; };
  };
  std::vector<SpinRow> shown;
  std::copy_if(rows.begin(), rows.end(), std::back_inserter(shown),
               [&](const SpinRow &row) {
                 return row.harmonics == rows.back().harmonics || !row.relative_change ||
                        changes_by(1e-9)(row);
               });
  if (one_ring)
    shown.push_back(*one_ring);
  Json table = shown_spin_rows(shown);
  if (one_ring)
    table.back()["harmonics"] = std::to_string(one_ring->harmonics) + ", on one ring";
  document.findings.summary["truncation"] = declared(spin_rows(rows), "truncation");
  document.facts["shown_truncations"] = table;
  document.facts["has_truncation_curve"] = std::count_if(rows.begin(), rows.end(), changes_by(1e-12)) > 2;
  document.plots["truncation"] = { { "rounding", 1e-12 } };
}

void add_bands(const std::vector<BandedQuantity> &bands, Document &document)
{
  std::vector<BandedQuantity> listed;
  std::copy_if(bands.begin(), bands.end(), std::back_inserter(listed),
               [](const BandedQuantity &each) { return !each.is_zero(); });
  const Json parts = part_rows(listed);
  document.facts["bands"] = band_rows(listed);
  document.facts["band_parts"] = parts;
  document.facts["has_band_parts"] = !parts.empty() && parts[0].size() > 1;
}

Json load_summary(const LoadReport &load)
{
  Json summary = { { "radii", Json::array() }, { "rings", Json::array() } };
  for (const ring::RingStack::Ring &ring : load.rings.rings())
  {
    summary["radii"].push_back(ring.radius);
    summary["rings"].push_back({ { "a", ring.a }, { "b", ring.b } });
  }
  summary.update(series_summary(load.rings));
  summary.update({ { "normal_force", load.normal_force },
                   { "moment", { load.moment.x(), load.moment.y() } },
                   { "moment_ratio", load.moment_ratio },
                   { "ring_radius", load.rings.radius() } });
  summary.update(STEMWARE_JSON(load, mean_radius, contact_fraction, azimuth_fraction, minimum, peak_pressure,
                               contact_width));
  return summary;
}

Json band_rows(const std::vector<BandedQuantity> &bands)
{
  Json rows = Json::array();
  for (const BandedQuantity &each : bands)
    rows.push_back({ { "quantity", each.quantity.name },
                     { "shown_value", format::to_spread(each.quantity.value, each.band) },
                     { "band", each.band },
                     { "shown_richardson", format::to_spread(each.richardson, each.band) },
                     { "shown_unit", each.quantity.unit == "1" ? format::missing : each.quantity.unit } });
  return rows;
}

Json band_summary(const std::vector<BandedQuantity> &bands)
{
  Json summary = Json::object();
  for (const BandedQuantity &each : bands)
  {
    Json parts = Json::object();
    for (const char *part : band_parts)
      parts[part] = part_of(each, part);
    summary[each.quantity.key] = { { "value", each.quantity.value },
                                   { "band", each.band },
                                   { "parts", parts },
                                   { "unit", each.quantity.unit } };
  }
  return summary;
}

} // namespace stemware::pipeline
