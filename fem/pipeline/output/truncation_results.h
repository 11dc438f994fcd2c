#pragma once

#include "fem/pipeline/analysis/truncation.h"
#include "fem/pipeline/coupling/contact_report.h"
#include "fem/pipeline/output/results.h"

namespace stemware::pipeline
{

/// The results of `truncate`: what is left of the answer with fewer harmonics, in balance where the study's
/// load is two-way. @p load is the study's at rest.
Results tabulate(const Study &study, const LoadReport &load, const TruncationStudy &truncations);

} // namespace stemware::pipeline
