#pragma once

#include "fem/pipeline/analysis/comparison.h"
#include "fem/pipeline/report/results.h"

namespace stemware::pipeline
{

/// The results of `compare`: loads and truncations beside moment balances.
Results tabulate(const Study &study, const Comparison &comparison);

} // namespace stemware::pipeline
