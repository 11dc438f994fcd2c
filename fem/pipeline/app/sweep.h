#pragma once

#include "fem/pipeline/analysis/sweep/sweep_plan.h"
#include "fem/pipeline/app/options.h"

namespace stemware::pipeline
{

/// What `stemware sweep` was told.
struct SweepOptions : StudyOptions
{
  SweepRequest request;
  unsigned int n_jobs =
    0; ///< cases that a process solves at a time; 0: as many as it has cores, one under mpirun
  bool restart = false; ///< throws away the finished cases of an earlier sweep into the same place
};

/// Solves the cases of a sweep, from the study's file to the folder of its results, and goes on where the
/// same sweep was interrupted. Collective over all ranks, which share the cases. Throws BadInput,
/// OutputFailure, and std::runtime_error when not a single case could be solved.
void sweep(const SweepOptions &options);

} // namespace stemware::pipeline
