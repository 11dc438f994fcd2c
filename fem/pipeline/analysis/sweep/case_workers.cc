#include "fem/pipeline/analysis/sweep/case_workers.h"

#include "fem/contact/contact_newton.h"
#include "fem/pipeline/coupling/failure_sentence.h"
#include "fem/pipeline/support/parallel.h"
#include "fem/pipeline/support/ranks.h"

#include <chrono>
#include <mutex>

namespace stemware::pipeline
{

namespace
{

/// One case, whatever becomes of it: trouble with it ends up in the result's message. With @p ranks_wait,
/// throws what perhaps this rank alone has met, for which the others would wait.
CaseResult attempt_case(const SweepPlan &plan, std::size_t index, fem::ComplianceCache &cache,
                        bool ranks_wait)
{
  CaseResult result;
  try
  {
    return solve_case(plan.study_of(index), cache);
  }
  catch (const fem::ContactFailure &failure)
  {
    result.outcome = fem::to_string(failure.outcome);
    result.message = failure_sentence();
  }
  catch (const BadInput &)
  {
    result.message = failure_sentence();
  }
  catch (...)
  {
    if (ranks_wait)
      throw;
    result.message = failure_sentence();
  }
  return result;
}

} // namespace

bool needs_all_ranks(const SweepPlan &plan, std::size_t index)
{
  try
  {
    const Study study = plan.study_of(index);
    return study.load.is_from_contact() && abilities(study.contact.body).is_collective;
  }
  catch (const BadInput &)
  {
    return false;
  }
}

void solve_on_threads(const SweepPlan &plan, const std::vector<std::size_t> &indices, unsigned int n_threads,
                      CaseLog &log, const std::function<void()> &watch)
{
  fem::ComplianceCache cache;
  std::mutex mutex;
  auto last_watched = std::chrono::steady_clock::now();
  const auto finish = [&](std::size_t index, const CaseResult &result)
  {
    const std::lock_guard<std::mutex> lock(mutex);
    log.append(index, result);
    const auto now = std::chrono::steady_clock::now();
    if (now - last_watched < std::chrono::milliseconds(200))
      return;
    last_watched = now;
    watch();
  };
  watch();
  parallel_for_each(indices.size(), n_threads,
                    [&](std::size_t i) { finish(indices[i], attempt_case(plan, indices[i], cache, false)); });
  watch();
}

void solve_together(const SweepPlan &plan, const std::vector<std::size_t> &indices, CaseLog &log,
                    const std::function<void()> &watch)
{
  fem::ComplianceCache cache;
  for (const std::size_t index : indices)
  {
    watch();
    const CaseResult result = attempt_case(plan, index, cache, n_ranks() > 1);
    on_first_rank([&] { log.append(index, result); });
  }
  watch();
}

} // namespace stemware::pipeline
