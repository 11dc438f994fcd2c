#include "fem/pipeline/report/goal_results.h"

#include "fem/pipeline/report/render/table_renderers.h"
#include "fem/pipeline/study/study_file.h"

namespace stemware::pipeline
{

std::optional<double> band_of_mesh(const Study &study, const ErrorBands &bands)
{
  const auto banded = find_quantity(bands, key_of(study.contact.goal));
  if (banded == bands.end() || banded->parts.count("mesh") == 0)
    return std::nullopt;
  return banded->parts.at("mesh");
}

nlohmann::ordered_json goal_summary(const Study &study, const GoalOutcome &goal, const FootReport &foot,
                                    const ErrorBands &bands)
{
  const nlohmann::ordered_json entries = study_as_json(study)["Contact"];
  return { { "name", entries["Goal"] },
           { "value", goal.value },
           { "estimated_error", json_number(goal.estimated_error) },
           { "band_of_mesh", json_number(band_of_mesh(study, bands)) },
           { "tolerance", entries["Goal tolerance"] },
           { "meshes", goal.n_meshes },
           { "cells", goal.n_cells },
           { "unknowns", foot.foot.n_unknowns } };
}

} // namespace stemware::pipeline
