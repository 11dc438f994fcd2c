#include "fem/pipeline/report/convergence_results.h"

#include "fem/pipeline/report/common_sections.h"
#include "fem/pipeline/report/facts.h"
#include "fem/pipeline/report/head.h"
#include "fem/pipeline/report/plots/plots.h"
#include "fem/pipeline/report/quantities.h"
#include "fem/pipeline/report/render/table_renderers.h"
#include "fem/pipeline/study/study_size.h"

#include <algorithm>
#include <cmath>

namespace stemware::pipeline
{

namespace
{

using Json = nlohmann::ordered_json;

/// The rows that are not zero by symmetry.
Table without_zeros(Table table, const std::vector<BandedQuantity> &quantities)
{
  for (Column &column : table.columns)
  {
    std::vector<Cell> cells;
    for (std::size_t i = 0; i < quantities.size(); ++i)
      if (!quantities[i].is_zero())
        cells.push_back(column.cells.at(i));
    column.cells = cells;
  }
  return table;
}

Json axis_as_json(const AxisResult &result, const std::vector<BandedQuantity> &quantities)
{
  Json levels = Json::array();
  for (const RefinementLevel &level : result.axis.levels)
    levels.push_back(level.size);
  Json sequences = Json::object();
  for (std::size_t i = 0; i < quantities.size(); ++i)
  {
    const RefinementSequence &judged = result.quantities[i].judged;
    sequences[quantities[i].quantity.key] = { { "values", result.quantities[i].values },
                                              { "order", json_number(judged.order) },
                                              { "limit", judged.limit },
                                              { "bands", judged.bands } };
    const QuantitySequence &sequence = result.quantities[i];
    if (sequence.corrections.empty())
      continue;
    Json corrections = Json::array(), effectivities = Json::array();
    for (std::size_t l = 0; l < sequence.values.size(); ++l)
    {
      corrections.push_back(json_number(sequence.corrections[l]));
      effectivities.push_back(json_number(sequence.effectivity(l, quantities[i].quantity.rounding)));
    }
    sequences[quantities[i].quantity.key]["corrections"] = corrections;
    sequences[quantities[i].quantity.key]["effectivity"] = effectivities;
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
  Json axes = Json::object();
  for (const AxisResult &axis : result.axes)
    axes[axis.axis.key] = axis_as_json(axis, result.quantities);
  findings.summary = {
    { "refinement", axes },
    { "error_bands", json_by_name(band_table(result.quantities).with("", "key value band unit richardson")) }
  };
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
  Table table = { "Refinement of the " + result.axis.name,
                  { column(Quantity("", result.axis.size), result.axis.levels, &RefinementLevel::size) } };
  for (std::size_t i = 0; i < quantities.size(); ++i)
    table.columns.push_back(
      numbers(quantities[i].quantity.name, quantities[i].quantity.unit, result.quantities[i].values));
  table.columns.push_back(column(quantity::unknowns_of_level, result.axis.levels, cost_of));
  return table;
}

/// Three rows, one column a quantity.
Table band_data(const std::vector<BandedQuantity> &bands)
{
  Table table = { "Values, half-widths of their error bands, Richardson values", {} };
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

/// Relative distances from the limit, without the levels that are at the limit to within rounding.
struct ErrorCurve
{
  std::vector<double> size, error, band;
};

ErrorCurve errors_of(const AxisResult &result, std::size_t i, const QuantityOfInterest &quantity)
{
  const QuantitySequence &sequence = result.quantities[i];
  const double scale = std::abs(sequence.judged.limit);
  ErrorCurve curve;
  for (std::size_t l = 0; l < sequence.values.size(); ++l)
  {
    const double error = std::abs(sequence.values[l] - sequence.judged.limit);
    if (error <= quantity.rounding || scale <= quantity.rounding)
      continue;
    curve.size.push_back(place_of(result.axis, l));
    curve.error.push_back(error / scale);
    curve.band.push_back(sequence.judged.bands[l] / scale);
  }
  return curve;
}

/// A triangle of this @p order below the last step of a curve of two levels or more.
ErrorCurve slope_triangle(const ErrorCurve &errors, double order)
{
  const std::size_t last = errors.size.size() - 1;
  const double fine = errors.size[last], coarse = errors.size[last - 1];
  const double low = 0.4 * std::min(errors.error[last], errors.error[last - 1]);
  const double high = low * std::pow(std::max(fine, coarse) / std::min(fine, coarse), order);
  return { { fine, coarse, coarse, fine }, { low, high, low, low }, {} };
}

/// Adds the errors of the drawn quantities by level; returns whether there are some, and not all levels
/// agree.
bool add_axis_plot(const AxisResult &result, const std::vector<BandedQuantity> &quantities,
                   Document &document)
{
  const std::string label =
    is_of_halvings(result.axis) ? "size of the cells over that without halvings, h / h_0" : result.axis.size;
  std::vector<std::string> titles, triangle;
  std::vector<Table> blocks;
  std::vector<double> sizes;
  Table slope;
  for (const std::size_t i : drawn_quantities(quantities))
  {
    const ErrorCurve curve = errors_of(result, i, quantities[i].quantity);
    if (curve.size.empty())
      continue;
    titles.push_back(quantities[i].quantity.name);
    blocks.push_back({ titles.back(),
                       { numbers(label, "1", curve.size), numbers("relative error", "1", curve.error),
                         numbers("half-width of the error band", "1", curve.band) } });
    sizes.insert(sizes.end(), curve.size.begin(), curve.size.end());
    const std::optional<double> &order = result.quantities[i].judged.order;
    if (!triangle.empty() || !order || curve.size.size() < 2)
      continue;
    triangle = { "order " + format::fixed<1>(*order) };
    const ErrorCurve sides = slope_triangle(curve, *order);
    slope = { triangle.front(),
              { numbers(label, "1", sides.size), numbers("relative error", "1", sides.error) } };
  }
  if (titles.empty())
    return false;
  if (!triangle.empty())
    blocks.push_back(slope);
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
Table spin_budget_table(const RefinementResult &result)
{
  const std::size_t spin = index_of(result.quantities, "omega_terminal");
  std::vector<std::string> names, sizes;
  std::vector<std::optional<double>> bands, orders, own_costs, finest_costs;
  for (const AxisResult &axis : result.axes)
  {
    const RefinementSequence &judged = axis.quantities.at(spin).judged;
    names.push_back(axis.axis.name);
    sizes.push_back(axis.axis.size + ": " + std::to_string(axis.axis.levels.at(axis.axis.own).size));
    bands.push_back(judged.bands.at(axis.axis.own));
    orders.push_back(judged.order);
    own_costs.push_back(cost_of(axis.axis.levels.at(axis.axis.own)));
    finest_costs.push_back(cost_of(axis.axis.levels.back()));
  }
  names.push_back("all together");
  sizes.push_back("");
  bands.push_back(result.quantities[spin].band);
  for (auto *column : { &orders, &own_costs, &finest_costs })
    column->push_back(std::nullopt);
  return { "Error band of the terminal spin, axis by axis",
           { column(quantity::refined, names), column(quantity::own_size, sizes),
             column(quantity::spin_band, bands), column(quantity::observed_order, orders),
             column(quantity::own_unknowns, own_costs), column(quantity::finest_unknowns, finest_costs) } };
}

/// The errors that dual problems estimate on each level of @p axis, beside those against the level two
/// further on; nothing where none are estimated.
std::optional<Table> effectivity_table(const AxisResult &axis, const std::vector<BandedQuantity> &quantities)
{
  std::vector<std::string> names, levels;
  std::vector<std::optional<double>> corrections, errors, ratios;
  for (std::size_t i = 0; i < quantities.size(); ++i)
  {
    const QuantitySequence &sequence = axis.quantities[i];
    for (std::size_t l = 0; l < sequence.corrections.size(); ++l)
    {
      if (!sequence.corrections[l])
        continue;
      names.push_back(quantities[i].quantity.name);
      levels.push_back(std::to_string(axis.axis.levels[l].size));
      corrections.push_back(sequence.corrections[l]);
      errors.push_back(sequence.error(l));
      ratios.push_back(sequence.effectivity(l, quantities[i].quantity.rounding));
    }
  }
  if (names.empty())
    return std::nullopt;
  return Table{ "What the " + axis.axis.name +
                  " leaves out: by a dual problem, and measured two levels further on",
                { column(quantity::quantity_name, names),
                  column(quantity::mesh_level.with(&Quantity::heading, "halvings"), levels),
                  column(quantity::mesh_correction, corrections), column(quantity::mesh_error, errors),
                  column(quantity::effectivity, ratios) } };
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

Table level_table(const AxisResult &result, const std::vector<BandedQuantity> &quantities)
{
  const RefinementAxis &axis = result.axis;
  Table table = { "Values on each level of the " + axis.name + "; * the study's own",
                  { column(quantity::quantity_name.with(&Quantity::label, axis.size), quantities,
                           [](const BandedQuantity &row) { return row.quantity.name; }) } };
  for (std::size_t l = 0; l < axis.levels.size(); ++l)
  {
    const std::string name = std::to_string(axis.levels[l].size) + (l == axis.own ? " *" : "");
    table.columns.push_back(
      column(Quantity("", "", "1", name, name, format::significant<9>, format::significant<8>),
             result.quantities, [=](const QuantitySequence &sequence) { return sequence.values.at(l); }));
  }
  if (axis.decay == Decay::algebraic)
    table.columns.push_back(column(quantity::observed_order, result.quantities,
                                   [](const QuantitySequence &sequence) { return sequence.judged.order; }));
  table.columns.push_back(column(quantity::error_band, result.quantities,
                                 [&](const QuantitySequence &sequence)
                                 { return sequence.judged.bands.at(axis.own); }));
  return table;
}

Results tabulate(const Study &study, const RefinementResult &result)
{
  const std::size_t index = index_of(result.quantities, "omega_terminal");
  const BandedQuantity &spin = result.quantities[index];
  const AxisResult &first = result.axes.front();
  Document document = { findings_of(result) };
  document.facts = { { "with_band", with_band(spin.quantity.value, spin.band) },
                     { "order", json_number(first.quantities[index].judged.order) },
                     { "first_axis", first.axis.name },
                     { "richardson", format::to_spread(spin.richardson, spin.band) },
                     { "axes", Json::array() } };
  add_head(study, { { "this glass", spin.quantity.value } }, document);
  for (const AxisResult &axis : result.axes)
  {
    const std::string &key = axis.axis.key;
    const std::optional<Table> effectivities = effectivity_table(axis, result.quantities);
    document.facts["axes"].push_back({ { "key", key },
                                       { "name", axis.axis.name },
                                       { "has_curves", add_axis_plot(axis, result.quantities, document) },
                                       { "has_effectivities", effectivities.has_value() } });
    document.tables["data_" + key] = axis_data(axis, result.quantities);
    document.tables["levels_" + key] = without_zeros(level_table(axis, result.quantities), result.quantities);
    if (effectivities)
      document.tables["effectivity_" + key] = *effectivities;
  }
  document.tables["axes"] = spin_budget_table(result);
  document.tables["error_bands"] = band_data(result.quantities);
  document.tables["main_bands"] = band_table(main_quantities(result.quantities));
  add_bands(result.quantities, document);
  return shown(document, "converge");
}

} // namespace stemware::pipeline
