#pragma once

#include "fem/pipeline/analysis/refinement_study.h"
#include "fem/pipeline/result/results.h"

namespace stemware::pipeline
{

/// Returns the results of `converge` from the solved @p axes and their total @p bands.
Results make_document(const Study &study, const std::vector<RefinementAxis> &axes, const ErrorBands &bands);

/// Returns the table of the quantities of @p bands on every level of the axes.
Table level_table(const std::vector<RefinementAxis> &axes, const ErrorBands &bands);

/// Returns the JSON Schema of the summary of `converge`.
Json converge_schema();

} // namespace stemware::pipeline
