#include "fem/pipeline/report/common_sections.h"

#include "fem/pipeline/document/shown_rows.h"

#include <boost/algorithm/string/replace.hpp>

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

} // namespace

Json shown_truncations(const Json &rows)
{
  const double torque_at_rest = std::abs(rows.back().value("tau_at_rest", 0.));
  Json shown = Json::array();
  for (const Json &row : rows)
    if (row == rows.back() || !row["rest_terminal"].is_number() ||
        std::abs(row["rest_terminal"].get<double>()) > 1e-9 * torque_at_rest)
      shown.push_back(row);
  zero_rounding_errors(shown, "change_half change_terminal change_largest rest_half rest_terminal",
                       1e-12 * torque_at_rest);
  zero_rounding_errors(shown, "change_half_relative change_terminal_relative change_largest_relative", 1e-12);
  zero_rounding_errors(shown, "spin_change", 1e-11);
  return shown;
}

void add_truncations(const Json &rows, const ring::TorqueEffects &effects, Document &document)
{
  document.findings.summary["truncation"] = declared(rows, "truncation");
  document.add_rows("truncations", shown_truncations(rows), truncation_keys);
  std::vector<std::pair<std::string, std::vector<double>>> curves = { { "omega", effects.spins } };
  for (const ring::TorqueEffect &effect : effects.rows)
    if (effect.harmonics > 1)
      curves.emplace_back(std::to_string(effect.harmonics), effect.curve);
  document.add_columns("torque_changes", curves);
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
  if (const auto spin = find_quantity(bands, "omega_terminal"); spin != bands.end())
  {
    const std::vector<double> spins = spins_of_interest(spin->quantity.value);
    for (std::size_t i = 0; i < spins.size(); ++i)
      if (const auto torque = summary.find("tau_at_spin_" + std::to_string(i + 1)); torque != summary.end())
        (*torque)["omega"] = spins[i];
  }
  return summary;
}

} // namespace stemware::pipeline
