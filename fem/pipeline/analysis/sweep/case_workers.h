#pragma once

#include "fem/pipeline/analysis/sweep/case_log.h"
#include "fem/pipeline/analysis/sweep/sweep_plan.h"

#include <functional>

namespace stemware::pipeline
{

/// Whether a case is one that all ranks solve together, after another: a solid body. False for cases that
/// cannot even be read.
bool needs_all_ranks(const SweepPlan &plan, std::size_t index);

/// Solves cases, at most @p n_threads at a time, and logs each as soon as it is finished, whatever becomes of
/// it: trouble with a case ends up in its result's message. Cases that need all ranks are solved @p together,
/// one after another, and logged by the first rank. Meanwhile @p watch is called by one thread at a time, a
/// few times a second. Throws OutputFailure when the log does, and what perhaps one of several ranks alone
/// has met in a case that they solve together.
void solve_cases(const SweepPlan &plan, const std::vector<std::size_t> &indices, unsigned int n_threads,
                 bool together, CaseLog &log, const std::function<void()> &watch);

} // namespace stemware::pipeline
