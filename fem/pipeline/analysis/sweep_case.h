#pragma once

#include "fem/pipeline/analysis/study_answer.h"

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace stemware::pipeline
{

struct CaseList;

/// Returns the columns of sweep.csv: all_quantities() with a column.
const std::vector<Quantity> &sweep_columns();

/// Result of one case of a sweep.
struct CaseResult
{
  std::string outcome = {}; ///< outcome of the contact solve; empty without one
  /// "ok"; "formal" if a load without a contact is negative somewhere; "tips" (also at rest); "failed".
  std::string status = "ok";
  std::string message = {}; ///< reason for missing values, or empty
  /// Values by key of sweep_columns(), without missing ones.
  std::map<std::string, double> values = {};

  std::optional<double> value(const std::string &key) const;
};

/// Solves a study as `run` does with Depth::answer, on a new foot with the mesh of mesh_for_goal(). @p start:
/// foot of a similar study, whose contacts are initial guesses (they change the result within tolerance);
/// replaced by the foot of @p study. Throws as foot_of(), find_load() and rows_by_harmonics().
CaseResult case_result(const Study &study, const Executor &executor,
                       std::shared_ptr<ElasticFoot> *start = nullptr);

/// Results by index of the case.
using FinishedCases = std::map<std::size_t, CaseResult>;

/// Solves the cases @p wanted, @p n_threads at a time (a solid body one after another with all threads).
/// @p finish receives each result when it is available, in any order, one at a time; its exceptions end the
/// work. Failed cases have a message and affect no others. Throws std::bad_alloc and OutputFailure.
void solve_cases(const CaseList &list, const std::vector<std::size_t> &wanted, unsigned int n_threads,
                 const std::function<void(std::size_t, const CaseResult &)> &finish);

} // namespace stemware::pipeline
