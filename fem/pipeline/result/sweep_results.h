#pragma once

#include "fem/pipeline/analysis/case_list.h"
#include "fem/pipeline/analysis/sweep_case.h"
#include "fem/pipeline/result/results.h"

namespace stemware::pipeline
{

/// Returns the results of `sweep` beside sweep.csv: ranges of spin and harmonic effect, failures, and for a
/// grid its curves or maps. Cases that are not @p finished are left out.
Results sweep_results(const CaseList &list, const FinishedCases &finished);

/// Returns the JSON Schema of the summary of `sweep`.
Json sweep_schema();

} // namespace stemware::pipeline
