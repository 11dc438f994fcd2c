#pragma once

#include "fem/pipeline/analysis/quantity.h"
#include "fem/pipeline/analysis/solve.h"

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
  std::string outcome; ///< of the contact; empty if there was none
  std::string message; ///< cause of a case without numbers, one sentence; empty if the case is solved
  std::map<std::string, double> values = {}; ///< values by key; missing values are left out
  bool tips_at_rest = false;                 ///< the glass tips before it spins: no numbers, no failure
  bool is_formal =
    false; ///< the load, which no contact gives, is negative somewhere: numbers without physics

  bool has_failed() const { return !message.empty() && !tips_at_rest; }
  std::optional<double> value(const std::string &key) const;
  /// True if the glass stands at rest and tips on the way: an answer without a terminal spin.
  bool falls_over() const { return values.count("omega_fall") > 0; }
  /// "ok", "formal", "tips" or "failed".
  std::string status() const
  {
    return has_failed() ? "failed" : falls_over() || tips_at_rest ? "tips" : is_formal ? "formal" : "ok";
  }
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
/// cases. Throws std::bad_alloc and OutputFailure, which are no properties of a case.
void solve_cases(const CaseList &list, const std::vector<std::size_t> &wanted, unsigned int n_threads,
                 const std::function<void(std::size_t, const CaseResult &)> &finish);

} // namespace stemware::pipeline
