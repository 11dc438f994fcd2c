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

struct FoundCase;
struct SweepPlan;
class CaseLog;

/// A number that is found for every case of a sweep.
struct SweepQuantity
{
  std::string name;
  std::string unit; ///< "1" for pure numbers
  std::function<std::optional<double>(const FoundCase &)> value;
};

/// All of them, in the order of the table.
const std::vector<SweepQuantity> &sweep_quantities();

/// Position of the quantity of that name; throws std::logic_error where there is none.
std::size_t quantity_index(const std::string &name);

/// The quantity that has a value for each case in which the glass stands at rest and falls over on the way.
inline constexpr char spin_of_fall[] = "spin at which it falls over";

/// Result of one case of a sweep.
struct CaseResult
{
  std::string outcome;                       ///< of the contact; empty where there was none
  std::string message;                       ///< why the case failed, one sentence; empty where it did not
  std::vector<std::optional<double>> values; ///< of sweep_quantities(); empty where the case failed

  bool is_solved() const { return message.empty(); }
  std::optional<double> value(std::size_t quantity) const; ///< its number in sweep_quantities()
  bool falls_over() const;                                 ///< an answer: there is no terminal spin
};

/// The result of a study on @p foot, its own, that nobody has asked: equal studies have equal results,
/// whatever was solved before or beside them. A glass that falls over on the way is an answer. Throws as
/// find_load() and spin_row().
CaseResult case_result(const Study &study, const std::shared_ptr<ElasticFoot> &foot,
                       const Executor &executor);

/// Finished cases by their number, from 0.
using FinishedCases = std::map<std::size_t, CaseResult>;

/// Solves the cases that are not @p finished, at most @p n_threads at a time, and logs each as soon as it is
/// finished, whatever becomes of it: trouble with a case ends up in its result's message. Collective: the
/// ranks share the cases, but those of a solid body they solve together, one after another, logged by the
/// first one. Meanwhile @p watch is called by one thread at a time, a few times a second. Throws
/// OutputFailure when the log does, and what perhaps one of several ranks alone has met in a case that they
/// solve together.
void solve_cases(const SweepPlan &plan, const FinishedCases &finished, unsigned int n_threads, CaseLog &log,
                 const std::function<void()> &watch);

} // namespace stemware::pipeline
