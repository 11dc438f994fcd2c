#include "fem/pipeline/output/converge_results.h"

#include "fem/pipeline/output/answer.h"
#include "fem/pipeline/support/text_file.h"
#include "fem/pipeline/support/text_layout.h"

#include <cmath>

namespace stemware::pipeline
{

using Json = nlohmann::ordered_json;

namespace
{

std::string order_text(const std::optional<double> &order)
{
  return order ? formatted("%.2f", *order) : "-";
}

std::string axis_table(const AxisResult &result, const std::vector<BandedFigure> &figures)
{
  TextColumn quantities = { result.axis.size, {}, true };
  TextColumn orders = { "order", {} };
  TextColumn bands = { "band", {} };
  std::vector<TextColumn> levels;
  for (std::size_t l = 0; l < result.axis.levels.size(); ++l)
    levels.push_back({ std::to_string(result.axis.levels[l].size) + (l == result.axis.own ? " *" : ""), {} });
  for (std::size_t f = 0; f < figures.size(); ++f)
  {
    const FigureSequence &sequence = result.figures[f];
    if (figures[f].is_zero())
      continue;
    quantities.cells.push_back(figures[f].figure.name);
    for (std::size_t l = 0; l < levels.size(); ++l)
      levels[l].cells.push_back(formatted("%.8g", sequence.values[l]));
    orders.cells.push_back(order_text(sequence.judged.order));
    bands.cells.push_back(band_text(sequence.judged.bands[result.axis.own]));
  }
  std::vector<TextColumn> columns = { quantities };
  columns.insert(columns.end(), levels.begin(), levels.end());
  if (result.axis.decay == Decay::algebraic)
    columns.push_back(orders);
  columns.push_back(bands);
  return text_table(columns);
}

std::string bands_table(const std::vector<BandedFigure> &figures)
{
  TextColumn quantities = { "quantity", {}, true };
  TextColumn values = { "value", {} };
  TextColumn limits = { "Richardson value", {} };
  TextColumn bands = { "band", {} };
  TextColumn units = { "unit", {}, true };
  for (const BandedFigure &banded : figures)
  {
    if (banded.is_zero())
      continue;
    quantities.cells.push_back(banded.figure.name);
    values.cells.push_back(formatted("%.9g", banded.figure.value));
    limits.cells.push_back(formatted("%.9g", banded.richardson));
    bands.cells.push_back(band_text(banded.band));
    units.cells.push_back(banded.figure.unit);
  }
  return text_table({ quantities, values, limits, bands, units });
}

Json axis_as_json(const AxisResult &result, const std::vector<BandedFigure> &figures)
{
  Json levels = Json::array();
  for (const RefinementLevel &level : result.axis.levels)
    levels.push_back(level.size);
  Json sequences = Json::object();
  for (std::size_t f = 0; f < figures.size(); ++f)
  {
    const FigureSequence &sequence = result.figures[f];
    sequences[figures[f].figure.key] = { { "values", sequence.values },
                                         { "order", number_or_null(sequence.judged.order) },
                                         { "limit", sequence.judged.limit },
                                         { "bands", sequence.judged.bands } };
  }
  return { { "name", result.axis.name },
           { "size", result.axis.size },
           { "levels", levels },
           { "own_level", result.axis.own },
           { "figures", sequences } };
}

} // namespace

std::string band_text(double band)
{
  if (!(band > 0))
    return "0";
  const double unit = std::pow(10., std::floor(std::log10(band)) - 1);
  return formatted("%.1e", std::ceil(band / unit * (1 - 1e-9)) * unit);
}

std::string refinement_tables(const RefinementResult &result)
{
  std::string text;
  for (const AxisResult &axis : result.axes)
    text += "\n" + axis.axis.name + " (* the study's own)\n" + axis_table(axis, result.figures);
  return text + "\nerror bands of the study as it is; harmonics not listed are zero\n" +
         bands_table(result.figures);
}

std::string refinement_answer(const RefinementResult &result)
{
  const BandedFigure &spin = result.figure("omega_terminal");
  const AxisResult &first = result.axes.front();
  const auto index = static_cast<std::size_t>(&spin - result.figures.data());
  std::string text =
    "Terminal spin " + with_band(spin.figure.value, spin.band) + " rad/s (discretisation only)";
  if (const auto &order = first.figures[index].judged.order)
    text += formatted("; it converges with order %.2f in the %s", *order, first.axis.name.c_str());
  return text + formatted(", Richardson value %.9g rad/s.", spin.richardson);
}

Json error_bands_as_json(const std::vector<BandedFigure> &figures)
{
  Json bands = Json::object();
  for (const BandedFigure &banded : figures)
    bands[banded.figure.key] = { { "value", banded.figure.value },
                                 { "band", banded.band },
                                 { "unit", banded.figure.unit } };
  return bands;
}

Findings refinement_findings(const RefinementResult &result)
{
  Findings findings;
  Json axes = Json::object();
  for (const AxisResult &axis : result.axes)
    axes[axis.axis.key] = axis_as_json(axis, result.figures);
  Json bands = error_bands_as_json(result.figures);
  for (const BandedFigure &banded : result.figures)
    bands[banded.figure.key]["richardson"] = banded.richardson;
  findings.summary = { { "refinement", axes }, { "error_bands", bands } };
  const BandedFigure &spin = result.figure("omega_terminal");
  findings.key_figures = { { "omega_terminal", spin.figure.value }, { "omega_terminal_band", spin.band } };
  return findings;
}

void write_refinement_tables(const RefinementResult &result, const std::filesystem::path &folder)
{
  for (const AxisResult &axis : result.axes)
  {
    std::vector<DataColumn> columns = { { axis.axis.size, "1", {} } };
    for (const RefinementLevel &level : axis.axis.levels)
      columns.front().values.push_back(level.size);
    for (std::size_t f = 0; f < result.figures.size(); ++f)
      columns.push_back(
        { result.figures[f].figure.name, result.figures[f].figure.unit, axis.figures[f].values });
    write_text_file(folder / ("converge_" + axis.axis.key + ".dat"),
                    data_table("Refinement of the " + axis.axis.name, columns));
  }
  std::vector<DataColumn> columns;
  for (const BandedFigure &banded : result.figures)
    columns.push_back(
      { banded.figure.name, banded.figure.unit, { banded.figure.value, banded.band, banded.richardson } });
  write_text_file(folder / "error_bands.dat",
                  data_table("Values, half-widths of their error bands, Richardson values", columns));
}

} // namespace stemware::pipeline
