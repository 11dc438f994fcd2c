#pragma once

#include "fem/pipeline/analysis/refinement/refinement_study.h"
#include "fem/pipeline/report/results.h"
#include "fem/pipeline/study/study.h"

#include <vector>

namespace stemware::pipeline
{

/// The results of `converge`: values, orders and limits along each axis, and the error bands.
Results tabulate(const Study &study, const RefinementResult &result);

/// The quantities of one axis by row: key and name, the values on each level (* the study's own), the
/// observed order where the errors fall algebraically, the band of the study's own level.
Table level_table(const AxisResult &axis, const std::vector<BandedQuantity> &quantities);

} // namespace stemware::pipeline
