#pragma once

#include "fem/pipeline/base/progress.h"
#include "fem/pipeline/coupling/balanced_load.h"
#include "fem/pipeline/coupling/elastic_foot.h"
#include "fem/pipeline/study/study.h"
#include "ring_model/spin/phases.h"

#include <memory>

namespace stemware::pipeline
{

/// Sampling of a load that depends on the phase. `coarse`, for results other than the answer, has fewer
/// samples than `full`: a quarter on a hard table, where each phase takes ten times as long.
enum class PhaseSampling
{
  full,
  coarse
};

/// Returns find_load() of a study whose load comes from a contact.
BalancedLoad contact_load(const Study &study, const std::shared_ptr<ElasticFoot> &foot,
                          unsigned int n_harmonics, Progress &progress, PhaseSampling phases);

/// Returns find_load() with the marks of glass and table at @p orientation, for a study with waviness.
BalancedLoad find_load_at_phase(const Study &study, const std::shared_ptr<ElasticFoot> &foot,
                                const ring::Orientation &orientation,
                                unsigned int n_harmonics = all_harmonics);

} // namespace stemware::pipeline
