#pragma once

#include "fem/pipeline/output/render/report.h"
#include "fem/pipeline/output/sweep_findings.h"

namespace stemware::pipeline
{

/// report.html of a sweep: curves over one entry, a family of curves or maps over two, or the spread of
/// random samples and what it comes from.
Report sweep_report(const SweepPlan &plan, const FinishedCases &cases, const SweepFindings &findings);

/// The pictures of a grid: curves over one entry of numbers, one family of curves for each word or each of a
/// few values of the other, or maps over both. Nothing where both entries are words.
std::vector<ReportFigure> grid_figures(const SweepPlan &plan, const FinishedCases &cases);

/// The pictures of random samples: how the terminal spin and the harmonic effect are distributed, and which
/// entries they depend on.
std::vector<ReportFigure> sample_figures(const SweepPlan &plan, const FinishedCases &cases,
                                         const SweepFindings &findings);

} // namespace stemware::pipeline
