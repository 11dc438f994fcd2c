#pragma once

#include "fem/pipeline/analysis/sweep/sweep_findings.h"
#include "fem/pipeline/report/results.h"

namespace stemware::pipeline
{

/// The results of `sweep`: curves over one entry, a family of curves or maps over two, or the spread of
/// random samples and what it comes from.
Results tabulate(const SweepPlan &plan, const FinishedCases &cases, const SweepFindings &findings);

/// Facts for the template "sweep_answer".
nlohmann::ordered_json sweep_facts(const SweepPlan &plan, const SweepFindings &findings);

/// sweep.csv: a row for every case of the plan in its order: case (from 1), the varied entries as they were
/// given, sweep_quantities(), contact outcome, status ("ok" or "failed") and message. What a case does not
/// have is missing.
Table case_table(const SweepPlan &plan, const FinishedCases &cases);

/// Quantities by row with where they lie: ranges with the values of their cases, and for random samples bands
/// and sensitivities, those of each entry in two columns.
Table statistics_table(const SweepPlan &plan, const std::vector<QuantityFindings> &quantities);

} // namespace stemware::pipeline
