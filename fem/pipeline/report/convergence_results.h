#pragma once

#include "fem/pipeline/analysis/refinement/refinement_study.h"
#include "fem/pipeline/report/results.h"
#include "fem/pipeline/study/study.h"

namespace stemware::pipeline
{

/// The results of `converge`: values, orders and limits along each axis, and the error bands.
Results tabulate(const Study &study, const RefinementResult &result);

} // namespace stemware::pipeline
