#pragma once

#include "fem/pipeline/base/progress.h"
#include "fem/pipeline/coupling/elastic_foot.h"

#include <cstddef>
#include <functional>
#include <utility>

namespace stemware::pipeline
{

/// Maker of the feet of variants, threads to solve them, and progress; no effect on results. One caller at a
/// time.
struct Executor
{
  using Work = std::function<void(std::size_t)>;

  /// Creates an executor with one thread. @p progress must outlive the executor.
  explicit Executor(FootMaker make_foot, Progress &progress = silent_progress())
      : make_foot(std::move(make_foot))
      , progress(progress)
  {
  }

  /// Calls @p work(i) for every i < @p n, in parallel unless @p sequential, started in order; waits for all.
  /// After an exception no further call starts, and the exception of the smallest i is rethrown. Parallel
  /// loops within @p work may use idle threads.
  void for_each(std::size_t n, const Work &work, bool sequential = false) const
  {
    if (run_in_parallel && !sequential)
      return run_in_parallel(n, work);
    for (std::size_t i = 0; i < n; ++i)
      work(i);
  }

  FootMaker make_foot;
  Progress &progress;
  /// True if every failure affects its own variant only. On several ranks this holds for
  /// is_variant_failure(), which occurs on all ranks; other failures end the work.
  bool keeps_all_failures = true;

protected:
  /// for_each() on several threads; empty: one thread.
  std::function<void(std::size_t n, const Work &work)> run_in_parallel;
};

} // namespace stemware::pipeline
