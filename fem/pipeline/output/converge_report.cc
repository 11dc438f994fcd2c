#include "fem/pipeline/output/converge_report.h"

#include "fem/pipeline/output/converge_results.h"
#include "fem/pipeline/output/render/plots.h"
#include "fem/pipeline/support/text_layout.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace stemware::pipeline
{

namespace
{

/// Quantities worth a curve: terminal spin, time constant, and the largest part of harmonics 2, 3 and 4.
std::vector<std::size_t> drawn_figures(const std::vector<BandedFigure> &figures)
{
  const auto index_of = [&](const std::string &key)
  {
    return static_cast<std::size_t>(std::distance(
      figures.begin(), std::find_if(figures.begin(), figures.end(),
                                    [&](const BandedFigure &banded) { return banded.figure.key == key; })));
  };
  std::vector<std::size_t> drawn = { index_of("omega_terminal"), index_of("time_constant") };
  for (const unsigned int n : { 2u, 3u, 4u })
  {
    const std::size_t a = index_of("a" + std::to_string(n));
    const std::size_t b = index_of("b" + std::to_string(n));
    drawn.push_back(std::abs(figures[a].figure.value) >= std::abs(figures[b].figure.value) ? a : b);
  }
  return drawn;
}

/// Relative distances from the limit, without the levels that are at the limit to within rounding.
ConvergenceSeries series_of(const AxisResult &result, std::size_t f, const FollowedFigure &figure)
{
  const FigureSequence &sequence = result.figures[f];
  const double scale = std::abs(sequence.judged.limit);
  ConvergenceSeries series = { figure.name, {}, {}, {} };
  for (std::size_t l = 0; l < sequence.values.size(); ++l)
  {
    const double error = std::abs(sequence.values[l] - sequence.judged.limit);
    if (error <= figure.rounding || scale <= figure.rounding)
      continue;
    series.size.push_back(result.axis.levels[l].size);
    series.error.push_back(error / scale);
    series.band.push_back(sequence.judged.bands[l] / scale);
  }
  return series;
}

ReportTable level_table(const AxisResult &result, const std::vector<BandedFigure> &figures)
{
  ReportTable table = { "Values on each level; * the study's own", { "quantity" }, {} };
  for (std::size_t l = 0; l < result.axis.levels.size(); ++l)
    table.header.push_back(std::to_string(result.axis.levels[l].size) + (l == result.axis.own ? " *" : ""));
  const bool has_orders = result.axis.decay == Decay::algebraic;
  if (has_orders)
    table.header.push_back("observed order");
  table.header.push_back("band");
  for (std::size_t f = 0; f < figures.size(); ++f)
  {
    if (figures[f].is_zero())
      continue;
    std::vector<std::string> row = { figures[f].figure.name };
    for (const double value : result.figures[f].values)
      row.push_back(formatted("%.9g", value));
    const RefinementSequence &judged = result.figures[f].judged;
    if (has_orders)
      row.push_back(judged.order ? formatted("%.2f", *judged.order) : "");
    row.push_back(band_text(judged.bands[result.axis.own]));
    table.rows.push_back(row);
  }
  return table;
}

ReportSection section_of(const AxisResult &result, const std::vector<BandedFigure> &figures)
{
  ReportSection section = { "Refinement: " + result.axis.name, "" };
  std::vector<ConvergenceSeries> series;
  for (const std::size_t f : drawn_figures(figures))
    if (ConvergenceSeries curve = series_of(result, f, figures[f].figure); !curve.size.empty())
      series.push_back(std::move(curve));
  if (series.empty())
    section.text = "All levels agree to within the tolerances of the contact solver.";
  else
    section.figures.push_back(convergence_figure(
      "converge_" + result.axis.key, "Relative distance from the limit; bars reach up to the error band",
      { result.axis.size, result.axis.sizes_double }, "relative error", series));

  section.tables.push_back(level_table(result, figures));
  return section;
}

} // namespace

ReportSection error_band_section(const std::vector<BandedFigure> &figures)
{
  ReportTable table = { "The study as it is; harmonics not listed are zero",
                        { "quantity", "value", "band", "Richardson value", "unit" },
                        {} };
  for (const BandedFigure &banded : figures)
    if (!banded.is_zero())
      table.rows.push_back({ banded.figure.name, formatted("%.9g", banded.figure.value),
                             band_text(banded.band), formatted("%.9g", banded.richardson),
                             banded.figure.unit });
  return { "Error bands",
           "The exact solution of the same model lies within value ± band: what the mesh, the harmonics and "
           "the azimuth lines leave open. How sure the model's parameters are is another matter.",
           {},
           { table } };
}

std::vector<double> spectrum_band(const std::vector<BandedFigure> &figures, unsigned int n_harmonics)
{
  if (figures.empty())
    return {};
  std::vector<double> bands(n_harmonics + 1, 0);
  for (unsigned int n = 1; n <= std::min(n_harmonics, n_followed_harmonics); ++n)
    bands[n] = std::hypot(band_of(figures, "a" + std::to_string(n)).value(),
                          band_of(figures, "b" + std::to_string(n)).value());
  return bands;
}

Report converge_report(const StudyOptions &options, const RefinementResult &result)
{
  Report report;
  report.title = "Refinement study of " + std::filesystem::path(options.study_file).filename().string();
  report.answer = refinement_answer(result);
  report.sections.push_back(error_band_section(result.figures));
  for (const AxisResult &axis : result.axes)
    report.sections.push_back(section_of(axis, result.figures));
  report.sections.push_back({ "Files",
                              "",
                              {},
                              {},
                              { { "summary.json", "everything, for programs" },
                                { "error_bands.dat", "values, bands, Richardson values" },
                                { "parameters.prm", "the study as it was refined" } } });
  return report;
}

} // namespace stemware::pipeline
