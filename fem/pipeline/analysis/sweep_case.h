#pragma once

#include "fem/pipeline/analysis/study_answer.h"

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace stemware::pipeline
{

/// Entry of a study that differs between cases.
struct VariedEntry
{
  std::string path;                     ///< Section/Entry
  std::string unit;                     ///< "1" for pure numbers, empty for words
  std::vector<std::string> values = {}; ///< values of a grid; empty for cases from a file
  bool by_factors = false;              ///< true for a logarithmic range
};

/// Cases of a sweep: one study, and for each case the values of some of its entries.
struct CaseList
{
  std::string origin;                    ///< "--vary" or "--cases my.csv", for error messages
  Study base = {};                       ///< study with all other entries
  std::vector<VariedEntry> entries = {}; ///< one or two for a grid, any number from a file
  /// Values [case][entry] in SI units, as in a study file; the last entry of a grid changes fastest.
  std::vector<std::vector<std::string>> cases = {};

  bool is_grid() const { return !entries.front().values.empty(); }

  /// Returns the study of a case. Throws BadInput if its values are not allowed together.
  Study study_of(std::size_t index) const;

  /// Returns the values of a case as text: "Load/Moment ratio = 1.3, Table/Foundation modulus = 1e9 Pa/m".
  std::string values_of(std::size_t index) const;
};

/// Makes the grid of one or two @p varied entries:
///
///   Load/Moment ratio=0.1:1.9:50                from 0.1 to 1.9 in equal steps, 50 values
///   Table/Foundation modulus=1e8:1e12:20:log    by equal factors
///   Motion/Mass=200,250,300 g                   a list; a unit after the last value applies to all
///   Motion/Closure=paper,hand,full              words
///
/// Values of a range are rounded to 15 digits of its larger end, so that the middle of -0.3 to 0.3 is 0.
/// Throws BadInput for other texts, unknown entries, inadmissible or repeated values.
CaseList cases_of_grid(const std::vector<std::string> &varied);

/// Reads cases from a table (parse_table()): one row per case, one column per entry, "Motion/Mass (g)". Cells
/// may have units and, unless commas separate them, decimal commas. Throws BadInput with line and column.
CaseList cases_from_file(const std::string &file);

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
