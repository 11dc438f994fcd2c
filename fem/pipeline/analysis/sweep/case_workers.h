#pragma once

#include "fem/pipeline/analysis/sweep/case_log.h"
#include "fem/pipeline/analysis/sweep/sweep_plan.h"

#include <functional>

namespace stemware::pipeline
{

/// Whether a case is one that all ranks solve together, after another: a solid body. False for cases that
/// cannot even be read.
bool needs_all_ranks(const SweepPlan &plan, std::size_t index);

/// Solves cases on @p n_threads threads of this process, and logs each as soon as it is finished, whatever
/// becomes of it: trouble with a case ends up in its result's message. Meanwhile
/// @p watch is called by one thread at a time, a few times a second. Only for cases that do not need all
/// ranks. Throws OutputFailure when the log does.
void solve_on_threads(const SweepPlan &plan, const std::vector<std::size_t> &indices, unsigned int n_threads,
                      CaseLog &log, const std::function<void()> &watch);

/// Solves cases one after another in the calling thread, on all ranks together; the first rank logs them. On
/// several ranks, throws what perhaps one of them alone has met.
void solve_together(const SweepPlan &plan, const std::vector<std::size_t> &indices, CaseLog &log,
                    const std::function<void()> &watch);

} // namespace stemware::pipeline
