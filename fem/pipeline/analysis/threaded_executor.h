#pragma once

#include "fem/pipeline/analysis/executor.h"
#include "fem/revolution/compliance_cache.h"

namespace stemware::pipeline
{

/// Executor with threads; feet come from make_foot() with a shared cache.
class ThreadedExecutor : public Executor
{
public:
  /// Creates an executor with @p n_threads. @p cache must outlive the executor.
  ThreadedExecutor(fem::ComplianceCache &cache, unsigned int n_threads = 1); // also converts a cache
};

} // namespace stemware::pipeline
