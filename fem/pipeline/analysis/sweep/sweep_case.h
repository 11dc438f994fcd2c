#pragma once

#include "fem/pipeline/variants/solve.h"

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace stemware::pipeline
{

struct CaseList;

/// Keys of the numbers that each case of a sweep has, in the order of sweep.csv; summary.schema.json declares
/// them.
const std::vector<std::string> &sweep_keys();

/// Result of one case of a sweep.
struct CaseResult
{
  std::string outcome;                       ///< of the contact; empty if there was none
  std::string message;                       ///< why the case failed, one sentence; empty if it did not
  std::map<std::string, double> values = {}; ///< by key, those that the case has

  bool is_solved() const { return message.empty(); }
  std::optional<double> value(const std::string &key) const;
  /// True if the glass stands at rest and falls over on the way: an answer, without a terminal spin.
  bool falls_over() const { return values.count("omega_fall") > 0; }
  /// "ok", "tips" or "failed".
  std::string status() const { return !is_solved() ? "failed" : falls_over() ? "tips" : "ok"; }
};

/// Solves a study on @p foot, its own, as far as the answer of `run` goes: all harmonics and the first alone.
/// Equal studies have equal results, whatever was solved before or beside them. Throws as find_load() and
/// rows_by_harmonics().
CaseResult case_result(const Study &study, const std::shared_ptr<ElasticFoot> &foot, const Executor &executor,
                       Progress &progress = silent_progress());

/// The same of a study without a foot yet, on the mesh for its goal. @p start: foot of a study that differs
/// little, near whose contacts the first ones are looked for; the foot of @p study afterwards. The result
/// then depends on @p start within the tolerance of the contact.
CaseResult case_result(const Study &study, const Executor &executor, Progress &progress = silent_progress(),
                       std::shared_ptr<ElasticFoot> *start = nullptr);

/// Results of cases by their number, from 0.
using FinishedCases = std::map<std::size_t, CaseResult>;

/// Solves the cases @p wanted, @p n_threads at a time; those of a solid body one after another, each with all
/// threads. @p finish receives each result as soon as it is there, in any order, from one thread at a time;
/// exceptions of @p finish end the work. A case that fails is a result with a message. No result depends on
/// other cases. Throws std::bad_alloc and OutputFailure of a case: they say nothing about the case.
void solve_cases(const CaseList &list, const std::vector<std::size_t> &wanted, unsigned int n_threads,
                 const std::function<void(std::size_t, const CaseResult &)> &finish);

} // namespace stemware::pipeline
