#include "fem/pipeline/analysis/sweep_case.h"

#include "fem/contact/contact_newton.h"
#include "fem/pipeline/analysis/goal_mesh.h"
#include "fem/pipeline/analysis/threaded_executor.h"
#include "fem/pipeline/base/failures.h"
#include "fem/pipeline/coupling/failure_sentence.h"
#include "fem/pipeline/coupling/study_load.h"
#include "ring_model/spin/curves.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <mutex>
#include <new>
#include <stdexcept>
#include <utility>

namespace stemware::pipeline
{

namespace
{

/// Returns the result of the case @p index, or its failure. Throws std::bad_alloc and OutputFailure.
CaseResult finished_case(const CaseList &list, std::size_t index, const Executor &executor)
try
{
  return case_result(list.study_of(index), executor);
}
catch (const std::exception &failure)
{
  if (dynamic_cast<const std::bad_alloc *>(&failure) || dynamic_cast<const OutputFailure *>(&failure))
    throw;
  const auto *contact = dynamic_cast<const fem::ContactFailure *>(&failure);
  return { contact ? fem::to_string(contact->outcome) : "", is_tipping(failure) ? "tips" : "failed",
           failure_sentence() };
}

/// Returns true if a case uses all threads; false for an invalid case.
bool is_collective_case(const CaseList &list, std::size_t index)
try
{
  return list.study_of(index).is_collective();
}
catch (const BadInput &)
{
  return false;
}

} // namespace

const std::vector<Quantity> &sweep_columns()
{
  static const std::vector<Quantity> columns = []
  {
    std::vector<Quantity> list;
    for (const auto &[quantity, value] : all_quantities().all())
      if (!quantity.column.empty())
        list.push_back(quantity);
    return list;
  }();
  return columns;
}

std::optional<double> CaseResult::value(const std::string &key) const
{
  const auto found = values.find(key);
  return found == values.end() ? std::nullopt : std::optional(found->second);
}

CaseResult case_result(const Study &study, const Executor &executor, std::shared_ptr<ElasticFoot> *start)
{
  const Variant variant = { { study, mesh_for_goal(study, executor).discretisation } };
  const auto foot = foot_of(variant, start ? *start : nullptr, executor);
  const BalancedLoad load = find_load(study, foot, executor.progress);
  StudyAnswer answer = { study };
  SpinStudy &spin = answer.spin;
  spin.rows = rows_by_harmonics({ study, foot, executor }, load, Depth::answer);
  std::optional<ring::Load> curve; // up to tipping, it would take as long as the search for this spin
  if (const std::optional<double> omega = spin.answer().omega_terminal())
    curve = ring::interpolated_for_curves(load, spin.answer(), std::min(0., *omega), std::max(0., *omega));
  spin.torque_effects = ring::torque_effects(load, study.motion.orbit, spin.answer(), { load.n_harmonics() },
                                             curve ? &*curve : nullptr);
  answer.contact.load = load.report();
  const std::optional<fem::ContactState> contact = load.contact(0);
  const bool is_formal = !contact && spin.answer().status == ring::Status::formal;
  CaseResult result = { "", spin.answer().fall ? "tips" : is_formal ? "formal" : "ok" };
  if (contact)
  {
    answer.contact.foot = FootReport{ {}, "", *contact, {}, {} };
    result.outcome = fem::to_string(contact->solution.outcome);
  }
  for (const auto &[quantity, value_of] : all_quantities().all())
    if (!quantity.column.empty())
      if (const Json value = value_of(answer); !value.is_null())
      {
        if (!std::isfinite(value.get<double>()))
          throw std::runtime_error("The result " + quantity.key +
                                   " is not a finite number; please report this study.");
        result.values[quantity.key] = value.get<double>() + 0.; // + 0. avoids -0
      }
  if (start)
    *start = foot;
  return result;
}

void solve_cases(const CaseList &list, const std::vector<std::size_t> &wanted, unsigned int n_threads,
                 const std::function<void(std::size_t, const CaseResult &)> &finish)
{
  std::vector<std::size_t> single, collective;
  for (const std::size_t index : wanted)
    (is_collective_case(list, index) ? collective : single).push_back(index);
  fem::ComplianceCache cache;
  const ThreadedExecutor within_case(cache);
  std::mutex mutex;
  for (const auto &[indices, threads] : { std::pair(single, n_threads), std::pair(collective, 1u) })
  {
    const auto solve_one = [&, &indices = indices](std::size_t i)
    {
      const CaseResult result = finished_case(list, indices[i], within_case);
      const std::lock_guard<std::mutex> lock(mutex);
      finish(indices[i], result);
    };
    ThreadedExecutor(cache, threads).for_each(indices.size(), solve_one);
  }
}

} // namespace stemware::pipeline
