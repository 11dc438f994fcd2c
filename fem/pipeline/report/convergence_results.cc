#include "fem/pipeline/report/convergence_results.h"

#include "fem/pipeline/report/common_sections.h"
#include "fem/pipeline/report/head.h"
#include "fem/pipeline/report/plots/plots.h"
#include "fem/pipeline/report/render/table_renderers.h"
#include "fem/pipeline/study/study_size.h"

#include <algorithm>
#include <cmath>

namespace stemware::pipeline
{

namespace
{

using Json = nlohmann::ordered_json;

Json axis_as_json(const AxisResult &result, const std::vector<BandedQuantity> &quantities)
{
  Json levels = Json::array(), sequences = Json::object();
  for (const RefinementLevel &level : result.axis.levels)
    levels.push_back(level.size);
  for (std::size_t i = 0; i < quantities.size(); ++i)
  {
    const QuantitySequence &sequence = result.quantities[i];
    Json figures = { { "values", sequence.values },
                     { "order", sequence.judged.order },
                     { "limit", sequence.judged.limit },
                     { "bands", sequence.judged.bands } };
    for (std::size_t l = 0; l < sequence.corrections.size(); ++l)
    {
      figures["corrections"].push_back(sequence.corrections[l]);
      figures["effectivity"].push_back(sequence.effectivity(l, quantities[i].quantity.rounding));
    }
    sequences[quantities[i].quantity.key] = figures;
  }
  return { { "name", result.axis.name },
           { "size", result.axis.size },
           { "levels", levels },
           { "own_level", result.axis.own },
           { "figures", sequences } };
}

Findings findings_of(const RefinementResult &result)
{
  Findings findings;
  Json axes = Json::object(), bands = Json::object();
  for (const AxisResult &axis : result.axes)
    axes[axis.axis.key] = axis_as_json(axis, result.quantities);
  for (const BandedQuantity &each : result.quantities)
    bands[each.quantity.key] = { { "value", each.quantity.value },
                                 { "band", each.band },
                                 { "unit", each.quantity.unit },
                                 { "richardson", each.richardson } };
  findings.summary = { { "refinement", axes }, { "error_bands", bands } };
  const BandedQuantity &spin = result.quantities[index_of(result.quantities, "omega_terminal")];
  findings.key_figures = { { "omega_terminal", spin.quantity.value }, { "omega_terminal_band", spin.band } };
  return findings;
}

/// Cost of a level: unknowns of its largest linear system, estimated.
double cost_of(const RefinementLevel &level)
{
  return size_of(level.study).unknowns;
}

// ---- files

/// Quantities on the levels of one axis, one row a level, one column a quantity.
Table axis_data(const AxisResult &result, const std::vector<BandedQuantity> &quantities)
{
  Table table = { "", { numbers(result.axis.size, "1", result.axis.levels, &RefinementLevel::size) } };
  for (std::size_t i = 0; i < quantities.size(); ++i)
    table.columns.push_back(
      numbers(quantities[i].quantity.name, quantities[i].quantity.unit, result.quantities[i].values));
  table.columns.push_back(
    numbers("unknowns of the largest linear system, estimated", "1", result.axis.levels, cost_of));
  return table;
}

/// Values, half-widths of their error bands and Richardson values in three rows, one column a quantity.
Table band_data(const std::vector<BandedQuantity> &bands)
{
  Table table;
  for (const BandedQuantity &banded : bands)
    table.columns.push_back(numbers(banded.quantity.name, banded.quantity.unit,
                                    { banded.quantity.value, banded.band, banded.richardson }));
  return table;
}

// ---- report

/// Quantities worth a curve: terminal spin, time constant, and the larger part of harmonics 2, 3 and 4.
std::vector<std::size_t> drawn_quantities(const std::vector<BandedQuantity> &quantities)
{
  std::vector<std::size_t> drawn = { index_of(quantities, "omega_terminal"),
                                     index_of(quantities, "time_constant") };
  for (const unsigned int n : { 2u, 3u, 4u })
  {
    const std::size_t a = index_of(quantities, "a" + std::to_string(n));
    const std::size_t b = index_of(quantities, "b" + std::to_string(n));
    const auto size = [&](std::size_t i) { return std::abs(quantities[i].quantity.value); };
    drawn.push_back(size(a) >= size(b) ? a : b);
  }
  return drawn;
}

/// Whether the levels count how often the cells are halved.
bool is_of_halvings(const RefinementAxis &axis)
{
  return axis.decay == Decay::algebraic && !axis.sizes_double;
}

/// Where a level stands on the horizontal axis: its cell size where cells are halved, else its number.
double place_of(const RefinementAxis &axis, std::size_t level)
{
  const double size = axis.levels.at(level).size;
  return is_of_halvings(axis) ? std::pow(2., -size) : size;
}

/// Rows of size, relative error and relative band.
using ErrorCurve = std::vector<std::vector<double>>;

/// Relative distances from the limit, without the levels that are at the limit to within rounding.
ErrorCurve errors_of(const AxisResult &result, std::size_t i, const QuantityOfInterest &quantity)
{
  const auto &[values, judged, corrections] = result.quantities[i];
  const double scale = std::abs(judged.limit);
  ErrorCurve curve;
  for (std::size_t l = 0; l < values.size(); ++l)
    if (const double error = std::abs(values[l] - judged.limit);
        error > quantity.rounding && scale > quantity.rounding)
      curve.push_back({ place_of(result.axis, l), error / scale, judged.bands[l] / scale });
  return curve;
}

/// A triangle of this @p order below the last step of a curve of two levels or more; it has no band.
ErrorCurve slope_triangle(const ErrorCurve &errors, double order)
{
  const auto &last = errors.back(), &before = errors[errors.size() - 2];
  const double fine = last[0], coarse = before[0], low = 0.4 * std::min(last[1], before[1]);
  const double high = low * std::pow(std::max(fine, coarse) / std::min(fine, coarse), order);
  return { { fine, low }, { coarse, high }, { coarse, low }, { fine, low } };
}

/// Adds the errors of the drawn quantities by level; returns whether there are some, and not all levels
/// agree.
bool add_axis_plot(const AxisResult &result, const std::vector<BandedQuantity> &quantities,
                   Document &document)
{
  const std::string label =
    is_of_halvings(result.axis) ? "size of the cells over that without halvings, h / h_0" : result.axis.size;
  std::vector<std::string> titles, triangle;
  std::vector<Table> blocks, slope;
  std::vector<double> sizes;
  for (const std::size_t i : drawn_quantities(quantities))
  {
    const ErrorCurve curve = errors_of(result, i, quantities[i].quantity);
    if (curve.empty())
      continue;
    titles.push_back(quantities[i].quantity.name);
    blocks.push_back(number_rows(
      titles.back(), { { label, "1" }, { "relative error", "1" }, { "half-width of the error band", "1" } },
      curve));
    for (const std::vector<double> &row : curve)
      sizes.push_back(row[0]);
    const std::optional<double> &order = result.quantities[i].judged.order;
    if (!triangle.empty() || !order || curve.size() < 2)
      continue;
    triangle = { "order " + format::number(*order, ".1f") };
    slope = { number_rows(triangle.front(), { { label, "1" }, { "relative error", "1" } },
                          slope_triangle(curve, *order)) };
  }
  if (titles.empty())
    return false;
  blocks.insert(blocks.end(), slope.begin(), slope.end());
  const bool is_logarithmic = result.axis.decay == Decay::algebraic || result.axis.sizes_double;
  const std::string &key = result.axis.key;
  document.texts["plot_of_" + key] = data_tables(blocks);
  document.plots["converge_" + key] = {
    { "axis", key },     { "x_label", label },     { "is_logarithmic", is_logarithmic }, { "size", sizes },
    { "curve", titles }, { "triangle", triangle }, { "has_triangle", !triangle.empty() }
  };
  return true;
}

/// Error bands of the terminal spin, axis by axis, with observed orders and costs.
Json axis_rows(const RefinementResult &result)
{
  const std::size_t spin = index_of(result.quantities, "omega_terminal");
  Json rows = Json::array();
  for (const AxisResult &each : result.axes)
  {
    const RefinementAxis &axis = each.axis;
    const RefinementSequence &judged = each.quantities.at(spin).judged;
    const RefinementLevel &own = axis.levels.at(axis.own);
    rows.push_back({ { "axis", axis.name },
                     { "own", axis.size + ": " + std::to_string(own.size) },
                     { "band", judged.bands.at(axis.own) },
                     { "order", judged.order },
                     { "own_unknowns", cost_of(own) },
                     { "finest", cost_of(axis.levels.back()) } });
  }
  rows.push_back({ { "axis", "all together" },
                   { "own", "" },
                   { "band", result.quantities[spin].band },
                   { "order", nullptr },
                   { "own_unknowns", nullptr },
                   { "finest", nullptr } });
  return rows;
}

/// The errors that dual problems estimate on each level of an axis, beside those against the level two
/// further on; empty where none are estimated.
Json effectivity_rows(const AxisResult &axis, const std::vector<BandedQuantity> &quantities)
{
  Json rows = Json::array();
  for (std::size_t i = 0; i < quantities.size(); ++i)
  {
    const QuantitySequence &sequence = axis.quantities[i];
    for (std::size_t l = 0; l < sequence.corrections.size(); ++l)
      if (sequence.corrections[l])
        rows.push_back({ { "quantity", quantities[i].quantity.name },
                         { "level", std::to_string(axis.axis.levels[l].size) },
                         { "correction", sequence.corrections[l] },
                         { "error", sequence.error(l) },
                         { "effectivity", sequence.effectivity(l, quantities[i].quantity.rounding) } });
  }
  return rows;
}

/// The quantities of one axis that are not zero by symmetry: the values on each level (* the study's own),
/// the observed order where the errors fall algebraically, the band of the study's own level.
Json level_rows(const AxisResult &result, const std::vector<BandedQuantity> &quantities)
{
  const RefinementAxis &axis = result.axis;
  Json rows = Json::array();
  for (std::size_t i = 0; i < quantities.size(); ++i)
  {
    const QuantitySequence &sequence = result.quantities[i];
    if (quantities[i].is_zero())
      continue;
    Json row = { { "quantity", quantities[i].quantity.name } };
    for (std::size_t l = 0; l < axis.levels.size(); ++l)
      row[std::to_string(axis.levels[l].size) + (l == axis.own ? " *" : "")] = sequence.values.at(l);
    if (axis.decay == Decay::algebraic)
      row["order"] = sequence.judged.order;
    row["band"] = sequence.judged.bands.at(axis.own);
    rows.push_back(row);
  }
  return rows;
}

/// The quantities that the console shows: the drawn ones that are not zero by symmetry.
std::vector<BandedQuantity> main_quantities(const std::vector<BandedQuantity> &quantities)
{
  std::vector<BandedQuantity> list;
  for (const std::size_t i : drawn_quantities(quantities))
    if (!quantities[i].is_zero())
      list.push_back(quantities[i]);
  return list;
}

} // namespace

Results tabulate(const Study &study, const RefinementResult &result)
{
  const std::size_t index = index_of(result.quantities, "omega_terminal");
  const BandedQuantity &spin = result.quantities[index];
  const AxisResult &first = result.axes.front();
  Document document = { findings_of(result) };
  document.facts = { { "with_band", format::with_band(spin.quantity.value, spin.band) },
                     { "order", first.quantities[index].judged.order },
                     { "first_axis", first.axis.name },
                     { "richardson", format::to_spread(spin.richardson, spin.band) },
                     { "axes", Json::array() } };
  add_study(study, { { "this glass", spin.quantity.value } }, document);
  for (const AxisResult &axis : result.axes)
  {
    const std::string &key = axis.axis.key;
    const Json effectivities = effectivity_rows(axis, result.quantities);
    document.facts["axes"].push_back({ { "key", key },
                                       { "name", axis.axis.name },
                                       { "has_curves", add_axis_plot(axis, result.quantities, document) },
                                       { "has_effectivities", !effectivities.empty() } });
    document.facts["levels"][key] = level_rows(axis, result.quantities);
    document.facts["effectivities"][key] = effectivities;
    document.tables["data_" + key] = axis_data(axis, result.quantities);
  }
  document.facts["spin_bands"] = axis_rows(result);
  document.facts["main_bands"] = band_rows(main_quantities(result.quantities));
  document.tables["error_bands"] = band_data(result.quantities);
  add_bands(result.quantities, document);
  return shown(document, "converge");
}

} // namespace stemware::pipeline
