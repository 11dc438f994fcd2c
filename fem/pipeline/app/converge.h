#pragma once

#include "fem/pipeline/app/options.h"

#include <vector>

namespace stemware::pipeline
{

/// What `stemware converge` was told.
struct ConvergeOptions
{
  StudyOptions study;
  unsigned int n_levels = 3;
  std::vector<double> spins; ///< at which the torque is followed [rad/s]; empty: followed_spins()
};

/// Solves a study on finer and coarser levels of each of its numerical parameters and writes observed orders,
/// limits and error bands. Collective over all ranks. Throws as run().
void converge(const ConvergeOptions &options);

} // namespace stemware::pipeline
