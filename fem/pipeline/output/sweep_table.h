#pragma once

#include "fem/pipeline/analysis/sweep/case_log.h"
#include "fem/pipeline/analysis/sweep/sweep_plan.h"

#include <string>

namespace stemware::pipeline
{

/// sweep.csv: a row for every case of the plan in its order, as RFC 4180 has it (commas, CRLF, fields with
/// commas, quotes or line ends in double quotes). Columns: case (from 1), the varied entries,
/// sweep_quantities(), contact outcome, status ("ok" or "failed") and message. The header reads "name (unit)"
/// for numbers, "name" for words; numbers have all their digits, and what a case does not have is left empty.
std::string sweep_csv(const SweepPlan &plan, const FinishedCases &cases);

} // namespace stemware::pipeline
