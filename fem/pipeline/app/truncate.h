#pragma once

#include "fem/pipeline/app/options.h"

#include <vector>

namespace stemware::pipeline
{

/// What `truncate` is told.
struct TruncateOptions
{
  StudyOptions study;
  std::vector<double> omega; ///< spins at which the torque is shown [rad/s]; empty: chosen by the study
};

/// Solves a study with fewer and fewer harmonics and writes the folder of its results. Collective over all
/// ranks. Throws as run().
void truncate(const TruncateOptions &options);

} // namespace stemware::pipeline
