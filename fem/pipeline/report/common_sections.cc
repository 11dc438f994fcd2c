#include "fem/pipeline/report/common_sections.h"

#include "fem/pipeline/report/budget_tables.h"
#include "fem/pipeline/report/plots/plots.h"
#include "fem/pipeline/report/quantities.h"
#include "fem/pipeline/report/render/table_renderers.h"
#include "fem/pipeline/report/run_tables.h"
#include "fem/pipeline/study/study_entries.h"
#include "fem/pipeline/support/numbers.h"

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace stemware::pipeline
{

namespace
{

using Json = nlohmann::ordered_json;

std::string value_of(const StudyEntry &entry)
{
  const std::string text = entry.text();
  return text.empty() ? "(none)" : text;
}

/// The unit of an entry; empty for pure numbers and words.
std::string unit_of(const StudyEntry &entry)
{
  return entry.unit == "1" ? "" : entry.unit;
}

/// A part of an error band: its key in BandedQuantity::parts and in summary.json, and its name in reports.
struct BandPart
{
  const char *key, *name;
};

/// All of them, in the order in which they are shown.
constexpr BandPart band_parts[] = { { "mesh", "mesh" },           { "degree", "degree" },
                                    { "harmonics", "harmonics" }, { "lines", "lines" },
                                    { "interface", "interface" }, { "load_harmonics", "load harmonics" },
                                    { "rings", "rings" },         { "interpolation", "interpolation" },
                                    { "solver", "solver" } };

/// A part of the band; nothing where it was not estimated.
std::optional<double> part_of(const BandedQuantity &quantity, const std::string &key)
{
  const auto part = quantity.parts.find(key);
  return part == quantity.parts.end() ? std::nullopt : std::optional(part->second);
}

/// Parts of error bands: a row for each band, a column for each part that one of them has.
Table part_table(const std::vector<BandedQuantity> &bands)
{
  Table table = band_table(bands).with("What the bands are made of", "quantity");
  for (const BandPart &part : band_parts)
    if (std::any_of(bands.begin(), bands.end(),
                    [&](const BandedQuantity &each) { return each.parts.count(part.key) > 0; }))
      table.columns.push_back(column(Quantity(part.key, part.name, "1", part.name, part.name, format::band),
                                     bands,
                                     [&](const BandedQuantity &each) { return part_of(each, part.key); }));
  return table;
}

/// The value of an entry to ten digits, which is what a reader can tell apart.
std::string shown_value(const StudyEntry &entry)
{
  const std::string text = value_of(entry);
  const std::optional<double> number = parse_number(text);
  return number && std::isfinite(*number) ? to_text(rounded(*number, 10)) : text;
}

/// The load where it was solved, to be drawn instead of a series that overshoots; nothing without lift-off.
std::vector<fem::AzimuthLoad> drawn_pointwise(const LoadReport &load)
{
  return load.contact_fraction < 1 ? load.pointwise : std::vector<fem::AzimuthLoad>();
}

} // namespace

void add_study(const Study &study, Document &document)
{
  Study given = study, usual;
  const std::vector<StudyEntry> entries = study_entries(given), defaults = study_entries(usual);
  std::vector<std::vector<std::string>> changed, all;
  for (std::size_t i = 0; i < entries.size(); ++i)
  {
    const StudyEntry &entry = entries[i];
    if (shown_value(entry) != shown_value(defaults[i]))
      changed.push_back({ entry.path(), shown_value(entry), shown_value(defaults[i]), unit_of(entry) });
    all.push_back({ entry.path(), value_of(entry), unit_of(entry), entry.help });
  }
  document.facts["is_default_study"] = changed.empty();
  document.tables["study_differences"] = words("", { "entry", "value", "default", "unit" }, changed);
  document.tables["study_entries"] = words("", { "entry", "value", "unit", "meaning" }, all);
}

void add_chain(const Study &study, const Budget &budget, Document &document)
{
  Budget steps = budget;
  steps.rows = named_steps(budget.rows);
  document.tables["chain"] = shown_budget_table(study, budget);
  document.tables["named_steps"] = shown_budget_table(study, steps);
  add_budget_plots(budget, 1e-9 * spin_scale(study), document);
}

void add_load(const Study &study, const LoadReport &load, const std::vector<BandedQuantity> &bands,
              Document &document)
{
  const std::vector<double> band = spectrum_band(bands, load.rings.n_harmonics());
  add_load_plots(load.rings, drawn_pointwise(load), band, study.motion.orbit.orbit_sense, document);
  document.tables["harmonics"] = harmonics_table(load.rings, band);
  document.tables["load"] = load_table(load.rings);
  document.tables["rings"] = ring_table(load.rings);
  document.tables["load_lines"] = pointwise_table(load.pointwise);
  document.texts["harmonics"] = load_file_text(load.rings);
}

void add_bands(const std::vector<BandedQuantity> &bands, Document &document)
{
  std::vector<BandedQuantity> listed;
  std::copy_if(bands.begin(), bands.end(), std::back_inserter(listed),
               [](const BandedQuantity &each) { return !each.is_zero(); });
  document.tables["bands"] = band_table(listed);
  document.tables["band_parts"] = part_table(listed);
  document.facts["has_band_parts"] = document.tables["band_parts"].columns.size() > 1;
}

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

Table harmonics_table(const ring::RingStack &load, const std::vector<double> &band)
{
  constexpr double rounding = 1e-12;
  const auto amplitude = [&](unsigned int n) { return std::hypot(load.a(n), load.b(n)) / load.a(0); };
  std::vector<unsigned int> orders;
  for (unsigned int n = 1; n <= std::min(load.n_harmonics(), 8u); ++n)
    if (band.empty() || band.at(n) <= amplitude(n))
      orders.push_back(n);
  /// Where a cos n theta + b sin n theta is largest [degrees], to a tenth, without the minus of a rounded
  /// zero.
  const auto crest = [&](unsigned int n) -> std::optional<double>
  {
    if (!(amplitude(n) > rounding))
      return std::nullopt;
    const double angle = std::atan2(load.b(n), load.a(n)) / n / boost::math::double_constants::degree;
    return std::round(10 * angle) / 10 + 0.;
  };
  return {
    "Harmonics of the load over its mean, a_0 = " + format::significant<6>(load.a(0)) + " N/rad",
    { column(quantity::harmonic, orders),
      column(
        quantity::cosine_share, orders, [&](unsigned int n) { return load.a(n) / load.a(0); }, rounding),
      column(
        quantity::sine_share, orders, [&](unsigned int n) { return load.b(n) / load.a(0); }, rounding),
      column(quantity::amplitude_share, orders, amplitude, rounding), column(quantity::crest, orders, crest) }
  };
}

Json series_summary(const ring::RingStack &load)
{
  Json a = Json::array(), b = Json::array();
  for (unsigned int n = 0; n <= load.n_harmonics(); ++n)
  {
    a.push_back(load.a(n));
    b.push_back(load.b(n));
  }
  return { { "a", a }, { "b", b } };
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
                   { "ring_radius", load.rings.radius() },
                   { "mean_radius", load.mean_radius },
                   { "contact_fraction", load.contact_fraction },
                   { "minimum", load.minimum } });
  return summary;
}

Table band_table(const std::vector<BandedQuantity> &bands)
{
  using Row = BandedQuantity;
  return { "",
           { column(quantity::quantity_key, bands, [](const Row &row) { return row.quantity.key; }),
             column(quantity::quantity_name, bands, [](const Row &row) { return row.quantity.name; }),
             column(quantity::value, bands, [](const Row &row) { return row.quantity.value; }),
             column(quantity::error_band, bands, &Row::band),
             column(quantity::unit, bands, [](const Row &row) { return row.quantity.unit; }),
             column(quantity::richardson, bands, &Row::richardson),
             column(quantity::value.with(&Quantity::key, "shown_value"), bands,
                    [](const Row &row) { return format::to_spread(row.quantity.value, row.band); }),
             column(quantity::richardson.with(&Quantity::key, "shown_richardson"), bands,
                    [](const Row &row) { return format::to_spread(row.richardson, row.band); }),
             column(quantity::unit.with(&Quantity::key, "shown_unit"), bands,
                    [](const Row &row) { return row.quantity.unit == "1" ? "–" : row.quantity.unit; }) } };
}

Json band_summary(const std::vector<BandedQuantity> &bands)
{
  Json summary = Json::object();
  for (const BandedQuantity &each : bands)
  {
    Json parts = Json::object();
    for (const BandPart &part : band_parts)
      parts[part.key] = json_number(part_of(each, part.key));
    summary[each.quantity.key] = { { "value", each.quantity.value },
                                   { "band", each.band },
                                   { "parts", parts },
                                   { "unit", each.quantity.unit } };
  }
  return summary;
}

} // namespace stemware::pipeline
