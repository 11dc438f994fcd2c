#pragma once

#include "fem/pipeline/analysis/solve.h"
#include "fem/revolution/compliance_cache.h"

namespace stemware::pipeline
{

/// Executor with threads; feet come from foot_maker() with a shared cache.
class ThreadedExecutor : public Executor
{
public:
  /// Creates an executor with @p n_threads. @p cache and @p progress must outlive the executor.
  ThreadedExecutor(fem::ComplianceCache &cache, unsigned int n_threads = 1, // also converts a cache
                   Progress &progress = silent_progress());
};

} // namespace stemware::pipeline
