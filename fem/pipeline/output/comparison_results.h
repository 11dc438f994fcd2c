#pragma once

#include "fem/pipeline/analysis/comparison.h"
#include "fem/pipeline/output/results.h"

namespace stemware::pipeline
{

/// The results of `compare`: loads and truncations beside moment balances.
Results comparison_results(const Study &study, const Comparison &comparison);

/// All rows; what does not exist is missing, and its state and message say why.
Table comparison_table(const std::vector<SpinRow> &rows);

} // namespace stemware::pipeline
