#include "fem/pipeline/report/common_sections.h"

#include "fem/pipeline/document/spin_rows.h"
#include "fem/pipeline/report/picture_columns.h"

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

/// The first harmonics of a load over its mean, for people; those that are smaller than their error band
/// @p band, by n as in spectrum_band(), are left out.
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
  zero_rounding_errors(rows, "a b amplitude", rounding);
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

} // namespace

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

void add_chain(const Study &study, const Budget &budget, Document &document)
{
  const std::vector<BudgetRow> steps = named_steps(budget.rows);
  const char *keys = "step title omega_terminal difference relative_difference band remark";
  const Json chain = shown_chain(study, budget.rows);
  document.add_rows("chain", chain, keys);
  document.add_rows("chain_torques", chain, "step title torques[]", "chain");
  add_waterfall(budget.rows, rounding_of_spins(study), document);
  document.add_rows("effects", effect_rows(steps, budget.without));
  document.words["band"] = budget.rows.empty() ? std::nullopt : budget.rows.back().band;
  add_harmonic_torque_columns(budget, document);
}

void add_load(const Study &study, const LoadReport &load, const ErrorBands &bands, Document &document)
{
  const std::vector<double> band = spectrum_band(bands, load.rings.n_harmonics());
  add_load_columns(load, first_harmonics_of(load.rings), study.motion.orbit.sense_sign(), document);
  add_spectrum_columns(load.rings, band, document);
  document.add_rows("load_harmonics", harmonic_rows(load.rings, band));
}

Json shown_truncations(const std::vector<ring::Answer> &rows, const std::optional<ring::Answer> &one_ring)
{
  std::vector<ring::Answer> shown;
  std::copy_if(rows.begin(), rows.end(), std::back_inserter(shown),
               [&](const ring::Answer &row)
               {
                 return row.harmonics == rows.back().harmonics || !row.relative_change ||
                        std::abs(*row.relative_change) > 1e-9;
               });
  if (one_ring)
    shown.push_back(*one_ring);
  Json table = shown_spin_rows(shown);
  if (one_ring)
    table.back()["harmonics"] = std::to_string(one_ring->harmonics) + ", on one ring";
  return table;
}

void add_truncations(const std::vector<ring::Answer> &rows, const std::optional<ring::Answer> &one_ring,
                     Document &document)
{
  document.findings.summary["truncation"] = declared(spin_rows(rows), "truncation");
  document.add_rows("truncations", shown_truncations(rows, one_ring),
                    "harmonics tau_at_rest omega_terminal relative_change bound load_minimum",
                    "shown_truncations");
  std::vector<double> harmonics, changes;
  for (const ring::Answer &row : rows)
    if (row.relative_change && std::abs(*row.relative_change) > 1e-12) // smaller ones say nothing
    {
      harmonics.push_back(row.harmonics);
      changes.push_back(std::abs(*row.relative_change));
    }
  document.add_columns("truncation_change", { { "harmonics", harmonics }, { "change", changes } });
}

void add_bands(const std::vector<BandedQuantity> &bands, Document &document)
{
  std::vector<BandedQuantity> listed;
  std::copy_if(bands.begin(), bands.end(), std::back_inserter(listed),
               [](const BandedQuantity &each) { return !each.is_zero(); });
  const Json parts = part_rows(listed);
  document.add_rows("bands", band_rows(listed), "quantity shown_value band shown_richardson shown_unit");
  if (!parts.empty() && parts[0].size() > 1)
    document.add_rows("band_parts", parts);
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
                     { "shown_value", format::rounded_to_error(each.quantity.value, each.band) },
                     { "band", each.band },
                     { "shown_richardson", format::rounded_to_error(each.richardson, each.band) },
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
