#include "fem/pipeline/analysis/sweep/case_workers.h"

#include "fem/contact/contact_newton.h"
#include "fem/pipeline/analysis/refinement/goal_mesh.h"
#include "fem/pipeline/coupling/failure_sentence.h"
#include "fem/pipeline/support/ranks.h"

#include <chrono>
#include <exception>
#include <memory>

namespace stemware::pipeline
{

namespace
{

/// The cases of a sweep as variants, each made when it is asked for.
struct Cases
{
  std::size_t size() const { return indices.size(); }
  Variant operator[](std::size_t i) const
  {
    return { "", "", mesh_for_goal(plan.study_of(indices[i]), executor).study };
  }

  const SweepPlan &plan;
  const std::vector<std::size_t> &indices;
  const Executor &executor;
};

CaseResult failed_case(const std::exception_ptr &failure)
{
  CaseResult result;
  try
  {
    std::rethrow_exception(failure);
  }
  catch (const fem::ContactFailure &contact)
  {
    result.outcome = fem::to_string(contact.outcome);
    result.message = failure_sentence();
  }
  catch (...)
  {
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

void solve_cases(const SweepPlan &plan, const std::vector<std::size_t> &indices, unsigned int n_threads,
                 bool together, CaseLog &log, const std::function<void()> &watch)
{
  fem::ComplianceCache cache;
  const Executor within_case(cache);
  Executor executor(cache, together ? 1 : n_threads);
  executor.keeps_all_failures = !together || n_ranks() == 1;
  auto last_watched = std::chrono::steady_clock::now();
  const auto finish = [&](std::size_t i, const Solved<CaseResult> &solved)
  {
    const CaseResult result = solved.answer ? *solved.answer : failed_case(solved.failure);
    const auto append = [&] { log.append(indices[i], result); };
    together ? on_first_rank(append) : append();
    const auto now = std::chrono::steady_clock::now();
    if (now - last_watched < std::chrono::milliseconds(200))
      return;
    last_watched = now;
    watch();
  };
  const auto result_of = [&](const Variant &variant, const std::shared_ptr<ElasticFoot> &foot)
  { return case_result(variant.study, foot, within_case); };
  watch();
  solve(Cases{ plan, indices, within_case }, nullptr, result_of, executor, finish);
  watch();
}

} // namespace stemware::pipeline
