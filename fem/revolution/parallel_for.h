#pragma once

#include <atomic>
#include <tbb/parallel_for.h>

namespace stemware::fem
{

/// Calls @p work(i) for every i < @p n on the threads of TBB, one call per task, and waits for all:
///
///     parallel_for(harmonics.size(), [&](unsigned int n) { harmonics[n] = compliance(n); });
///
/// @p work should not throw: an exception cancels the other calls.
template <typename Work>
void parallel_for(unsigned int n, const Work &work)
{
  // libtbb is not built with the thread sanitizer, so its synchronisation is invisible. The atomic repeats
  // it: writes before the loop are visible in each call, and writes of the calls are visible after the loop.
  std::atomic<unsigned int> n_finished;
  n_finished.store(0, std::memory_order_release);
  tbb::parallel_for(
    0u, n,
    [&](unsigned int i)
    {
      n_finished.load(std::memory_order_acquire);
      work(i);
      n_finished.fetch_add(1, std::memory_order_acq_rel);
    },
    tbb::simple_partitioner());
  n_finished.load(std::memory_order_acquire);
}

} // namespace stemware::fem
