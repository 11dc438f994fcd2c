#include "fem/pipeline/report/convergence_results.h"

#include "fem/pipeline/document/answers.h"
#include "fem/pipeline/document/study_words.h"
#include "fem/pipeline/input/study_size.h"
#include "fem/pipeline/report/common_sections.h"

namespace stemware::pipeline
{

using Json = nlohmann::ordered_json;

namespace
{

/// Values on every level of each axis, as converge.csv has them.
Json level_rows(const std::vector<RefinementAxis> &axes, const ErrorBands &bands)
{
  Json rows = Json::array();
  for (const RefinementAxis &axis : axes)
    for (std::size_t l = 0; l < axis.levels.size(); ++l)
    {
      Json &row = rows.emplace_back();
      row = { { "axis", axis.key },
              { "level (1)", static_cast<double>(l) - static_cast<double>(axis.own) },
              { "size (1)", axis.sizes[l] },
              { "unknowns (1)", size_of(axis.levels[l].study).unknowns } };
      for (std::size_t i = 0; i < bands.size(); ++i)
        row[with_unit(bands[i].quantity.name, bands[i].quantity.unit)] = axis.quantities[i].values[l];
    }
  return rows;
}

Json refinement_summary(const RefinementAxis &axis, const ErrorBands &bands)
{
  Json json = STEMWARE_JSON(axis, name, size);
  json.update({ { "levels", axis.sizes }, { "own_level", axis.own } });
  for (std::size_t i = 0; i < bands.size(); ++i)
    json["figures"][bands[i].quantity.key] = STEMWARE_JSON(axis.quantities[i], values, order, limit, bands);
  return json;
}

} // namespace

Results make_document(const Study &study, const std::vector<RefinementAxis> &axes, const ErrorBands &bands)
{
  const std::size_t index = index_of(bands, "omega_terminal");
  const BandedQuantity &spin = bands[index];
  Results results = { document_of(study, "discretisation error") };
  Json &summary = results.findings.summary, rows = Json::array();
  for (const RefinementAxis &axis : axes)
  {
    summary["refinement"][axis.key] = refinement_summary(axis, bands);
    const RefinementSequence &judged = axis.quantities[index];
    rows.push_back({ { "axis", axis.name },
                     { "own", axis.size + ": " + std::to_string(axis.sizes[axis.own]) },
                     { "band", judged.bands[axis.own] },
                     { "order", judged.order } });
  }
  rows.push_back({ { "axis", "all together" }, { "own", "" }, { "band", spin.band } });
  summary["error_bands"] = band_summary(bands);
  for (const BandedQuantity &each : bands)
    summary["error_bands"][each.quantity.key]["richardson"] = each.richardson;
  results.findings.key_figures = { { "omega_terminal", spin.quantity.value },
                                   { "omega_terminal_band", spin.band } };
  results.words["answer"] = convergence_answer(spin, axes.front().name, axes.front().quantities[index].order);
  results.words["rounding"] = spin.quantity.rounding;
  results.add_rows("spin_bands", rows);
  add_bands(bands, results);
  results.files = { { "summary.json", "everything, for programs" },
                    { "converge.csv", "the values on every level of each axis",
                      table_of(level_rows(axes, bands), "", "levels") },
                    { "parameters.prm", "the refined study" } };
  results.console = { { results.words["answer"] },
                      { "",
                        table_of(rows, "", "spin_bands", "Error band of the terminal spin, axis by axis") } };
  return results;
}

} // namespace stemware::pipeline
