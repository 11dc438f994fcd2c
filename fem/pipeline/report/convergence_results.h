#pragma once

#include "fem/pipeline/analysis/refinement/refinement_study.h"
#include "fem/pipeline/report/results.h"

namespace stemware::pipeline
{

/// The results of `converge`: solved @p axes and the @p bands that they make together.
Results make_document(const Study &study, const std::vector<RefinementAxis> &axes, const ErrorBands &bands);

} // namespace stemware::pipeline
