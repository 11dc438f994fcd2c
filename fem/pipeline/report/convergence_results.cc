#include "fem/pipeline/report/convergence_results.h"

#include "fem/pipeline/document/table.h"
#include "fem/pipeline/report/common_sections.h"
#include "fem/pipeline/report/head.h"
#include "fem/pipeline/study/study_size.h"

namespace stemware::pipeline
{

using Json = nlohmann::ordered_json;

Results tabulate(const Study &study, const std::vector<RefinementAxis> &axes, const ErrorBands &bands)
{
  const std::size_t index = index_of(bands, "omega_terminal");
  const auto &[spin, band, richardson, parts] = bands[index];
  Document document;
  Json &summary = document.findings.summary, &plot = document.plots["convergence"], rows = Json::array();
  for (const RefinementAxis &axis : axes)
  {
    Json &json = summary["refinement"][axis.key] = STEMWARE_JSON(axis, name, size);
    json.update({ { "levels", axis.sizes }, { "own_level", axis.own } });
    for (std::size_t i = 0; i < bands.size(); ++i)
      json["figures"][bands[i].quantity.key] = STEMWARE_JSON(axis.quantities[i], values, order, limit, bands);
    for (std::size_t l = 0; l < axis.levels.size(); ++l)
    {
      Json &row = document.facts["levels"].emplace_back();
      row = { { "axis", axis.key },
              { "level (1)", static_cast<double>(l) - static_cast<double>(axis.own) },
              { "size (1)", axis.sizes[l] },
              { "unknowns (1)", size_of(axis.levels[l].study).unknowns } };
      for (std::size_t i = 0; i < bands.size(); ++i)
        row[with_unit(bands[i].quantity.name, bands[i].quantity.unit)] = axis.quantities[i].values[l];
    }
    const RefinementSequence &judged = axis.quantities[index];
    rows.push_back({ { "axis", axis.name },
                     { "own", axis.size + ": " + std::to_string(axis.sizes[axis.own]) },
                     { "band", judged.bands[axis.own] },
                     { "order", judged.order } });
    plot["axis"].push_back(axis.key);
    plot["curve"].push_back(axis.name);
    plot["limit"].push_back(judged.limit);
  }
  rows.push_back({ { "axis", "all together" }, { "own", "" }, { "band", band } });
  plot.update({ { "rounding", spin.rounding }, { "spin_column", index + 5 } });
  summary["error_bands"] = band_summary(bands);
  for (const BandedQuantity &each : bands)
    summary["error_bands"][each.quantity.key]["richardson"] = each.richardson;
  document.findings.key_figures = { { "omega_terminal", spin.value }, { "omega_terminal_band", band } };
  document.facts.update({ { "with_band", format::with_band(spin.value, band) },
                          { "order", axes.front().quantities[index].order },
                          { "first_axis", axes.front().name },
                          { "richardson", format::to_spread(richardson, band) },
                          { "spin_bands", rows } });
  add_study(study, { { "this glass", spin.value } }, document);
  add_bands(bands, document);
  return shown(document, "converge");
}

} // namespace stemware::pipeline
