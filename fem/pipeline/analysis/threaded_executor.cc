#include "fem/pipeline/analysis/threaded_executor.h"

#include "fem/pipeline/base/ranks.h"
#include "fem/pipeline/coupling/make_foot.h"
#include "fem/revolution/parallel_for.h"

#include <deal.II/base/multithread_info.h>

#include <atomic>
#include <exception>
#include <tbb/task_arena.h>
#include <vector>

namespace stemware::pipeline
{

namespace
{

/// Limits deal.II, and thereby TBB in the whole process, to a number of threads during its lifetime.
class ThreadLimit
{
public:
  explicit ThreadLimit(unsigned int n_threads)
      : before(dealii::MultithreadInfo::n_threads())
  {
    dealii::MultithreadInfo::set_thread_limit(n_threads);
  }
  ~ThreadLimit() { dealii::MultithreadInfo::set_thread_limit(before); }
  ThreadLimit(const ThreadLimit &) = delete;
  ThreadLimit &operator=(const ThreadLimit &) = delete;

private:
  const unsigned int before;
};

/// Implements Executor::for_each() on @p n_threads threads.
void on_threads(unsigned int n_threads, std::size_t n, const Executor::Work &work)
{
  const ThreadLimit limit(n_threads);
  tbb::task_arena arena(static_cast<int>(n_threads));
  std::vector<std::exception_ptr> failures(n);
  std::atomic<bool> has_failed = false;
  // An exception that leaves one call of work() would cancel the parallel loops inside the other calls. For
  // example, deal.II would leave tables incomplete.
  const auto guarded = [&](std::size_t i)
  {
    if (has_failed)
      return;
    try
    {
      work(i);
    }
    catch (...)
    {
      failures[i] = std::current_exception();
      has_failed = true;
    }
  };
  // Isolation: a thread that waits for a loop inside one call of work() must not begin another call, because
  // the other call could wait for the first one (deadlock).
  std::atomic<std::size_t> next = 0; // calls start in ascending order, however the loop is divided
  const auto isolated = [&](std::size_t) { tbb::this_task_arena::isolate([&] { guarded(next++); }); };
  arena.execute([&] { fem::parallel_for(static_cast<unsigned int>(n), isolated); });
  for (const std::exception_ptr &failure : failures)
    if (failure)
      std::rethrow_exception(failure);
}

} // namespace

ThreadedExecutor::ThreadedExecutor(fem::ComplianceCache &cache, unsigned int n_threads, Progress &progress)
    : Executor(foot_maker(cache), progress)
{
  keeps_all_failures = n_ranks() == 1;
  if (n_threads > 1)
    run_in_parallel = [n_threads](std::size_t n, const Work &work) { on_threads(n_threads, n, work); };
}

} // namespace stemware::pipeline
