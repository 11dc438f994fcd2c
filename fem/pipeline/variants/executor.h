#pragma once

#include "fem/pipeline/coupling/study_load.h"

#include <cstddef>
#include <functional>
#include <utility>

namespace stemware::fem
{
class ComplianceCache;
}

namespace stemware::pipeline
{

/// Means by which variants are solved: who makes their feet, and who shares out the work. The answers do not
/// depend on either. For one caller at a time.
struct Executor
{
  using Work = std::function<void(std::size_t)>;

  /// Creates an executor with one thread.
  explicit Executor(FootMaker make_foot)
      : make_foot(std::move(make_foot))
  {
  }
  /// Feet by make_foot() that share @p cache, one thread unless @p n_threads are given; not in the live cut,
  /// which has neither meshes nor threads.
  Executor(fem::ComplianceCache &cache, unsigned int n_threads = 1); // a cache alone will do

  /// Calls @p work(i) for every i < @p n, side by side unless @p sequential, in their order, each as soon as
  /// a thread is free; returns when all are done. After one has thrown, no further ones are begun, and its
  /// exception (that of the least i, if several threw) is thrown here. Parallel loops within @p work do not
  /// mix with each other; they may take the threads that no call needs.
  void for_each(std::size_t n, const Work &work, bool sequential = false) const
  {
    if (run_in_parallel && !sequential)
      return run_in_parallel(n, work);
    for (std::size_t i = 0; i < n; ++i)
      work(i);
  }

  FootMaker make_foot;
  /// True if any failure leaves its variant alone without an answer. On several ranks only those do that
  /// is_variant_failure() knows, which all ranks meet together; others end the work.
  bool keeps_all_failures = true;

private:
  /// for_each() on several threads; nothing: there is one.
  std::function<void(std::size_t n, const Work &work)> run_in_parallel;
};

} // namespace stemware::pipeline
