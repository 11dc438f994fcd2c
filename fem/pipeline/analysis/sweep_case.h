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

/// Returns the quantities of each case, the columns of sweep.csv: study_quantities() with a column.
const std::vector<Quantity> &sweep_columns();

/// Result of one case of a sweep.
struct CaseResult
{
  std::string outcome = {}; ///< outcome of the contact solve; empty if no contact was solved
  /// "ok"; "formal" if the load, not of a contact, is negative somewhere; "tips" if the glass tips, at rest
  /// or on the way; or "failed".
  std::string status = "ok";
  std::string message = {}; ///< why there are no values, one sentence; empty if the case is solved
  /// Values by key of sweep_columns(); missing values are left out.
  std::map<std::string, double> values = {};

  std::optional<double> value(const std::string &key) const;
};

/// Solves a study on its own @p foot like `run` with Depth::answer: all harmonics and the first only. Equal
/// studies have equal results, independent of other cases. Throws as find_load() and rows_by_harmonics().
CaseResult case_result(const Study &study, const std::shared_ptr<ElasticFoot> &foot, const Executor &executor,
                       Progress &progress = silent_progress());

/// Makes the foot, on the mesh for the study's goal, and solves. @p start: foot of a similar study, whose
/// contacts are initial guesses; replaced by the foot of @p study. The result then depends on @p start within
/// the tolerance of the contact.
CaseResult case_result(const Study &study, const Executor &executor, Progress &progress = silent_progress(),
                       std::shared_ptr<ElasticFoot> *start = nullptr);

/// Results of cases by their number, from 0.
using FinishedCases = std::map<std::size_t, CaseResult>;

/// Solves the cases @p wanted, @p n_threads at a time (for a solid body one after another with all threads).
/// @p finish receives each result when it is available, in any order, from one thread at a time; its
/// exceptions end the work. A case that fails is a result with a message. Results do not depend on other
/// cases. Throws std::bad_alloc and OutputFailure, which do not depend on a case.
void solve_cases(const CaseList &list, const std::vector<std::size_t> &wanted, unsigned int n_threads,
                 const std::function<void(std::size_t, const CaseResult &)> &finish);

} // namespace stemware::pipeline
