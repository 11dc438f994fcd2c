#include "fem/pipeline/output/common_sections.h"

#include "fem/pipeline/output/quantities.h"
#include "fem/pipeline/output/render/table_renderers.h"
#include "fem/pipeline/study/study_entries.h"

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>

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

/// What was asked for: the entries that differ from the defaults, and all of them in a folded section.
std::vector<ReportSection> study_sections(const Study &study)
{
  Study given = study, usual;
  const std::vector<StudyEntry> entries = study_entries(given), defaults = study_entries(usual);
  std::vector<std::vector<std::string>> changed, all;
  for (std::size_t i = 0; i < entries.size(); ++i)
  {
    const StudyEntry &entry = entries[i];
    if (entry.text() != defaults[i].text())
      changed.push_back({ entry.path(), value_of(entry), value_of(defaults[i]), unit_of(entry) });
    all.push_back({ entry.path(), value_of(entry), unit_of(entry), entry.help });
  }
  ReportSection differences = { "The study", "What differs from the defaults (stemware defaults):" };
  if (changed.empty())
    differences.text = "Everything has its default value (stemware defaults).";
  else
    differences.tables = { words("", { "entry", "value", "default", "unit" }, changed) };
  ReportSection everything = { "All parameters", "" };
  everything.tables = { words("", { "entry", "value", "unit", "meaning" }, all) };
  everything.folded = true;
  return { differences, everything };
}

} // namespace

void add_closing_sections(Report &report, const Study &study, const std::vector<ResultFile> &files)
{
  for (const ReportSection &section : study_sections(study))
    report.sections.push_back(section);
  report.sections.push_back(file_section(files));
}

Table harmonics_table(const ring::RingStack &load)
{
  constexpr double rounding = 1e-12;
  std::vector<unsigned int> orders;
  for (unsigned int n = 1; n <= std::min(load.n_harmonics(), 8u); ++n)
    orders.push_back(n);
  const auto amplitude = [&](unsigned int n) { return std::hypot(load.a(n), load.b(n)) / load.a(0); };
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
  Json summary = series_summary(load.rings);
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
             column(quantity::richardson, bands, &Row::richardson) } };
}

ReportSection error_band_section(const std::vector<BandedQuantity> &bands)
{
  std::vector<BandedQuantity> listed;
  std::copy_if(bands.begin(), bands.end(), std::back_inserter(listed),
               [](const BandedQuantity &each) { return !each.is_zero(); });
  return {
    "Error bands",
    "The exact solution of the same model lies within value ± band: what the mesh, the harmonics and "
    "the azimuth lines leave open. The band says nothing about uncertain parameters such as μ, E or the "
    "mass; stemware sweep --random does.",
    {},
    { band_table(listed).with("The study as it is; harmonics not listed are zero",
                              "quantity value band richardson unit") }
  };
}

} // namespace stemware::pipeline
