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

} // namespace stemware::pipeline
