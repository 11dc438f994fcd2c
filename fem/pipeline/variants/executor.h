#pragma once

#include "fem/pipeline/coupling/study_load.h"

#include <cstddef>
#include <exception>
#include <functional>

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
  /// Calls work(i) for every i < n, as for_each() says.
  using Loop = std::function<void(std::size_t n, const Work &work)>;

  /// Without @p side_by_side one after the other.
  explicit Executor(FootMaker make_foot, Loop side_by_side = {});
  /// Feet by make_foot() that share @p cache, one thread unless @p n_threads are given; not in the live cut,
  /// which has neither meshes nor threads.
  Executor(fem::ComplianceCache &cache, unsigned int n_threads = 1); // a cache alone will do

  /// Calls @p work(i) for every i < @p n, side by side unless @p one_by_one, in their order, each as soon as
  /// a thread is free; returns when all are done. After one has thrown, no further ones are begun, and its
  /// exception (that of the least i, if several threw) is thrown here. Parallel loops within @p work do not
  /// mix with each other; they may take the threads that no call needs.
  void for_each(std::size_t n, const Work &work, bool one_by_one = false) const;

  /// Calls @p work and returns what it has thrown, nothing where it has not. What is no failure of a variant
  /// is thrown on.
  std::exception_ptr failure_of(const std::function<void()> &work) const;

  FootMaker make_foot;
  /// Whether any failure is one of the variant, as in a sweep, where the other cases go on. Else bad input,
  /// contacts and balances that do not exist are; all others end the work.
  bool keeps_all_failures = false;

private:
  Loop side_by_side; ///< nothing: there is one thread
};

} // namespace stemware::pipeline
