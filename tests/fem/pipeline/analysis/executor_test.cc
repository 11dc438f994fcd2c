#include "fem/pipeline/analysis/threaded_executor.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <tbb/parallel_for.h>
#include <thread>
#include <vector>

namespace stemware::pipeline
{
namespace
{

class WithoutThreadLimit
{
public:
  WithoutThreadLimit()
  {
    if (const char *const given = std::getenv(name))
      before = given;
    ::unsetenv(name);
  }
  ~WithoutThreadLimit()
  {
    if (!before.empty())
      ::setenv(name, before.c_str(), 1);
  }

private:
  static constexpr const char *name = "DEAL_II_NUM_THREADS";
  std::string before;
};

void on_threads(unsigned int n_threads, std::size_t n, const std::function<void(std::size_t)> &work)
{
  fem::ComplianceCache cache;
  ThreadedExecutor(cache, n_threads).for_each(n, work);
}

} // namespace

TEST(Executor, CallsEachIndexOnceOnAtMostTheGivenThreads)
{
  const WithoutThreadLimit unlimited;
  for (const unsigned int n_threads : { 1u, 2u, 3u })
  {
    std::vector<std::atomic<unsigned int>> n_calls(50);
    std::atomic<unsigned int> n_at_work = 0, most_at_work = 0;
    on_threads(n_threads, n_calls.size(),
               [&](std::size_t i)
               {
                 const unsigned int n = ++n_at_work;
                 for (unsigned int most = most_at_work; n > most;)
                   if (most_at_work.compare_exchange_weak(most, n))
                     break;
                 std::this_thread::sleep_for(std::chrono::milliseconds(2));
                 ++n_calls[i];
                 --n_at_work;
               });
    for (const auto &n : n_calls)
      EXPECT_EQ(n, 1u);
    EXPECT_LE(most_at_work, n_threads);
  }
  on_threads(4, 0, [](std::size_t) { FAIL(); });
}

TEST(Executor, RunsTwoCallsSimultaneously)
{
  const WithoutThreadLimit unlimited;
  std::atomic<unsigned int> n_begun = 0;
  on_threads(2, 2,
             [&](std::size_t)
             {
               // Each of the two calls waits until both calls have started. A single thread would never
               // return.
               ++n_begun;
               while (n_begun < 2)
                 std::this_thread::sleep_for(std::chrono::milliseconds(1));
             });
}

TEST(Executor, RethrowsAnExceptionAndStartsNoMoreCalls)
{
  std::atomic<unsigned int> n_calls = 0;
  const auto work = [&](std::size_t)
  {
    ++n_calls;
    throw std::runtime_error("no room");
  };
  EXPECT_THROW(on_threads(2, 1000, work), std::runtime_error);
  EXPECT_LE(n_calls, 2u);
}

TEST(Executor, AThreadStartsNoOtherOuterCallWhileItWaitsForItsInnerLoop)
{
  // Without task isolation, some threads would start another outer call.
  constexpr std::size_t n_outer = 200, n_inner = 8;
  thread_local bool at_work = false;
  std::atomic<std::size_t> n_mixed = 0, n_done = 0;
  const auto outer = [&](std::size_t i)
  {
    const bool was_at_work = at_work;
    n_mixed += was_at_work ? 1 : 0;
    at_work = true;
    const auto inner = [&](std::size_t k)
    {
      std::this_thread::sleep_for(std::chrono::microseconds(50 + 97 * (i * i % 11) + 300 * (k % 3)));
      ++n_done;
    };
    tbb::parallel_for(std::size_t(0), n_inner, inner, tbb::simple_partitioner());
    at_work = was_at_work;
  };
  on_threads(8, n_outer, outer);
  EXPECT_EQ(n_mixed, 0u);
  EXPECT_EQ(n_done, n_outer * n_inner);
}

} // namespace stemware::pipeline
