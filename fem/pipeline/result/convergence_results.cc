#include "fem/pipeline/base/numbers.h"
#include "fem/pipeline/result/common_sections.h"
#include "fem/pipeline/result/number_format.h"
#include "fem/pipeline/result/sentences.h"
#include "fem/pipeline/result/verb_results.h"
#include "fem/pipeline/study/study_size.h"

namespace stemware::pipeline
{

namespace
{

/// Row of converge.csv: one level of a refinement axis.
struct LevelRow
{
  const RefinementAxis &axis;
  std::size_t level;
};

struct ConvergeRow
{
  const std::vector<RefinementAxis> &axes;
  const ErrorBands &bands;
};

Fields<ConvergeRow> converge_fields()
{
  using Axis = RefinementAxis;
  using Sequence = RefinementSequence;
  const auto sequence_fields =
    Fields<Sequence>{ { "values", "", "Its values.", &Sequence::values },
                      { "order", "", "Observed order.", &Sequence::order },
                      { "limit", "", "Limit of the values.", &Sequence::limit },
                      { "bands", "", "Half-widths of the error bands.", &Sequence::bands } };
  const auto axis_fields =
    Fields<Axis>{ { "name", "", "Refined parameter.", &Axis::name },
                  { "size", "", "Unit of the levels.", &Axis::size },
                  { "levels", "", "Sizes of the levels.", &Axis::sizes },
                  { "own_level", "", "Index of the study's own level, from 0.", &Axis::own },
                  { "figures", "Quantities by key.", sequence_fields.by(&Sequence::key),
                    &Axis::quantities } };
  return { { "refinement", "Axes of refinement of `converge`, by key.", axis_fields.by(&Axis::key),
             [](const ConvergeRow &row) { return row.axes; } },
           { "error_bands", "Error bands by quantity.", band_fields(true),
             [](const ConvergeRow &row) { return row.bands; } } };
}

struct SpinBandRow
{
  std::string axis, own;
  double band;
  std::optional<double> order;
};

Table spin_band_table(const std::vector<SpinBandRow> &rows, Face face)
{
  return Fields<SpinBandRow>{
    { "axis", "", "", &SpinBandRow::axis, shown_as("what is refined") },
    { "own", "", "", &SpinBandRow::own, shown_as("the study has") },
    { "band", "rad/s", "", &SpinBandRow::band, shown_as("band"), with_digits("band") },
    { "order", "1", "", &SpinBandRow::order, on_page("observed order"), on_console("order"),
      with_digits(".2f") }
  }.table(rows, face, face == Face::console ? "Error band of the terminal spin, axis by axis" : "");
}

} // namespace

Json converge_schema()
{
  return converge_fields().schema();
}

Table level_table(const std::vector<RefinementAxis> &axes, const ErrorBands &bands)
{
  std::vector<LevelRow> rows;
  for (const RefinementAxis &axis : axes)
    for (std::size_t l = 0; l < axis.levels.size(); ++l)
      rows.push_back({ axis, l });
  Fields<LevelRow> fields = {
    { "axis", "", "", [](const LevelRow &row) { return row.axis.key; },
      in_file("axis", "axis of refinement") },
    { "level", "1", "",
      [](const LevelRow &row) { return static_cast<double>(row.level) - static_cast<double>(row.axis.own); },
      in_file("level", "level of the axis; 0 is the study") },
    { "size", "1", "", [](const LevelRow &row) { return row.axis.sizes[row.level]; },
      in_file("size", "size of the level: what the axis counts") },
    { "unknowns", "1", "",
      [](const LevelRow &row) { return size_of(row.axis.levels[row.level].study).unknowns; },
      in_file("unknowns", "unknowns of the largest linear system, estimated") }
  };
  for (std::size_t i = 0; i < bands.size(); ++i)
  {
    const QuantityOfInterest &quantity = bands[i].quantity;
    fields.add({ quantity.omega ? "tau_at_*" : quantity.key, quantity.unit, "",
                 [i](const LevelRow &row) { return row.axis.quantities[i].values[row.level]; },
                 in_file(quantity.name, quantity.name),
                 with_number(quantity.omega ? to_short_text(*quantity.omega) : "") });
  }
  return fields.table(rows, Face::file);
}

Results convergence_results(const Study &study, const std::vector<RefinementAxis> &axes,
                            const ErrorBands &bands)
{
  const std::size_t index = index_of(bands, "omega_terminal");
  const BandedQuantity &spin = bands[index];
  Results results = begun_results(study, "discretisation error");
  std::vector<SpinBandRow> rows;
  for (const RefinementAxis &axis : axes)
  {
    const RefinementSequence &judged = axis.quantities[index];
    rows.push_back({ axis.name, axis.size + ": " + std::to_string(axis.sizes[axis.own]),
                     judged.bands[axis.own], judged.order });
  }
  rows.push_back({ "all together", "", spin.band, std::nullopt });
  results.summary = converge_fields().json({ axes, bands });
  results.key_figures = { { "omega_terminal", spin.quantity.value }, { "omega_terminal_band", spin.band } };
  const std::optional<double> &order = axes.front().quantities[index].order;
  results.words["answer"] =
    "Terminal spin " + format::with_band(spin.quantity.value, spin.band) + " rad/s (discretisation only)" +
    (order ? "; it converges with order " + format::number(*order, ".2f") + " in the " + axes.front().name
           : "") +
    ", Richardson value " + format::rounded_to_error(spin.richardson, spin.band) +
    " rad/s. The band of stemware run differs: its levels are coarser, and it has parts for rings, load "
    "harmonics and the spring of a hard interface.";
  results.words["rounding"] = spin.quantity.rounding;
  results.add_table("spin_bands", spin_band_table(rows, Face::page));
  add_band_tables(bands, results);
  results.files = { { "summary.json", "everything, for programs" },
                    { "converge.csv", "the values on every level of each axis", level_table(axes, bands) },
                    { "parameters.prm", "the refined study" } };
  results.console = { results.words["answer"].get<std::string>(), spin_band_table(rows, Face::console) };
  return results;
}

} // namespace stemware::pipeline
