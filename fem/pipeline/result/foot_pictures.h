#pragma once

#include "fem/pipeline/analysis/quantities_of_interest.h"
#include "fem/pipeline/coupling/contact_report.h"
#include "fem/pipeline/result/results.h"

namespace stemware::pipeline
{

/// Adds "foot", numbers of the pictures of a foot: pressures, stresses, section and rim, if known; @p
/// bands: of the study's numbers.
void add_foot_pictures(const Study &study, const FootReport &foot, const ErrorBands &bands, Results &results);

} // namespace stemware::pipeline
