#pragma once

#include "fem/pipeline/analysis/refinement/quantities_of_interest.h"
#include "fem/pipeline/analysis/truncation.h"
#include "fem/pipeline/coupling/contact_report.h"
#include "fem/pipeline/report/results.h"

namespace stemware::pipeline
{

/// The results of `truncate`: what is left of the answer with fewer harmonics, in balance where the study's
/// load is two-way. @p load is the study's at rest, @p bands what is known about its errors.
Results tabulate(const Study &study, const LoadReport &load, const TruncationStudy &truncations,
                 const ErrorBands &bands);

/// The least number of harmonics from which on the terminal spin stays within @p share of that of all, which
/// is the last of @p rows.
unsigned int harmonics_enough(const std::vector<SpinRow> &rows, double share);

} // namespace stemware::pipeline
