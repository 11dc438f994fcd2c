#include "fem/pipeline/analysis/sweep/case_workers.h"

#include "fem/contact/contact_newton.h"
#include "fem/pipeline/coupling/failure_sentence.h"
#include "fem/pipeline/support/ranks.h"

#include <algorithm>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace stemware::pipeline
{

namespace
{

/// The result of a case that has failed with the exception that is being handled.
CaseResult failed_case()
{
  CaseResult result;
  result.message = failure_sentence();
  try
  {
    throw;
  }
  catch (const fem::ContactFailure &failure)
  {
    result.outcome = fem::to_string(failure.outcome);
  }
  catch (...)
  {
    // The message says what it was; there is no contact to speak of.
  }
  return result;
}

/// What the threads share.
class WorkShare
{
public:
  WorkShare(const SweepPlan &plan, const std::vector<std::size_t> &indices, CaseLog &log)
      : plan(plan)
      , indices(indices)
      , log(log)
  {
  }

  /// Takes case after case until there is none left, or the log fails.
  void work()
  {
    for (auto index = next(); index; index = next())
      finish(*index, attempt_case(plan, *index, store));
  }

  /// Waits for at most a fifth of a second; false when all cases are finished or the log has failed.
  bool wait()
  {
    std::unique_lock<std::mutex> lock(mutex);
    const auto is_over = [this] { return n_finished == indices.size() || log_failure; };
    return !changed.wait_for(lock, std::chrono::milliseconds(200), is_over);
  }

  void rethrow_log_failure() const
  {
    if (log_failure)
      std::rethrow_exception(log_failure);
  }

private:
  std::optional<std::size_t> next()
  {
    const std::lock_guard<std::mutex> lock(mutex);
    return n_begun < indices.size() && !log_failure ? std::optional(indices[n_begun++]) : std::nullopt;
  }

  void finish(std::size_t index, const CaseResult &result)
  {
    const std::lock_guard<std::mutex> lock(mutex);
    try
    {
      log.append(index, result);
      ++n_finished;
    }
    catch (...)
    {
      log_failure = std::current_exception();
    }
    changed.notify_one();
  }

  const SweepPlan &plan;
  const std::vector<std::size_t> &indices;
  CaseLog &log;
  fem::ComplianceStore store;
  std::mutex mutex;
  std::condition_variable changed;
  std::size_t n_begun = 0;
  std::size_t n_finished = 0;
  std::exception_ptr log_failure;
};

} // namespace

CaseResult attempt_case(const SweepPlan &plan, std::size_t index, fem::ComplianceStore &store)
{
  try
  {
    return solve_case(plan.study_of(index), store);
  }
  catch (...)
  {
    return failed_case();
  }
}

bool needs_all_ranks(const SweepPlan &plan, std::size_t index)
{
  try
  {
    const Study study = plan.study_of(index);
    return study.load.source == LoadSource::contact && study.contact.body == BodyKind::solid;
  }
  catch (const BadInput &)
  {
    return false;
  }
}

void solve_on_threads(const SweepPlan &plan, const std::vector<std::size_t> &indices, unsigned int n_threads,
                      CaseLog &log, const std::function<void()> &watch)
{
  if (indices.empty())
    return;
  WorkShare share(plan, indices, log);
  std::vector<std::thread> threads;
  for (std::size_t t = 0; t < std::min<std::size_t>(n_threads, indices.size()); ++t)
    threads.emplace_back([&] { share.work(); });
  do
    watch();
  while (share.wait());
  for (std::thread &thread : threads)
    thread.join();
  watch();
  share.rethrow_log_failure();
}

void solve_together(const SweepPlan &plan, const std::vector<std::size_t> &indices, CaseLog &log,
                    const std::function<void()> &watch)
{
  fem::ComplianceStore store;
  for (const std::size_t index : indices)
  {
    watch();
    CaseResult result;
    try
    {
      result = solve_case(plan.study_of(index), store);
    }
    catch (const BadInput &)
    {
      result = failed_case();
    }
    catch (const fem::ContactFailure &)
    {
      result = failed_case();
    }
    catch (...)
    {
      if (n_ranks() > 1)
        throw; // perhaps of this rank only, for which the others would wait
      result = failed_case();
    }
    on_first_rank(
      [&]
      {
        log.append(index, result);
        return std::string();
      });
  }
  watch();
}

} // namespace stemware::pipeline
