#pragma once

#include "fem/revolution/compliance_cache.h"

#include <cstddef>
#include <exception>
#include <functional>

namespace stemware::pipeline
{

/// Means by which variants are solved: the compliances that their feet share, and how many threads. The
/// answers do not depend on the threads. For one caller at a time.
struct Executor
{
  /// One thread unless @p n_threads are given.
  Executor(fem::ComplianceCache &cache, unsigned int n_threads = 1) // a cache alone will do
      : cache(cache)
      , n_threads(n_threads)
  {
  }

  /// Calls @p work(i) for every i < @p n, at most n_threads at a time unless @p one_by_one, each as soon as a
  /// thread is free; returns when all are done. After one has thrown, no further ones are begun, and its
  /// exception (that of the least i, if several threw) is thrown here. Parallel loops within @p work do not
  /// mix with each other; they may take the threads that no call needs.
  void for_each(std::size_t n, const std::function<void(std::size_t)> &work, bool one_by_one = false) const;

  /// Calls @p work and returns what it has thrown, nothing where it has not. What is no failure of a variant
  /// is thrown on.
  std::exception_ptr failure_of(const std::function<void()> &work) const;

  fem::ComplianceCache &cache;
  unsigned int n_threads;
  /// Whether any failure is one of the variant, as in a sweep, where the other cases go on. Else bad input,
  /// contacts and balances that do not exist are; all others end the work.
  bool keeps_all_failures = false;
};

} // namespace stemware::pipeline
