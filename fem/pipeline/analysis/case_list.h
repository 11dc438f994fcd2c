#pragma once

#include "fem/pipeline/study/study.h"

#include <cstddef>
#include <string>
#include <vector>

namespace stemware::pipeline
{

/// Entry of a study that differs from case to case.
struct VariedEntry
{
  std::string path;                     ///< Section/Entry
  std::string unit;                     ///< "1" for pure numbers, empty for words
  std::vector<std::string> values = {}; ///< values of a grid, in order; empty for a list from a file
  bool by_factors = false;              ///< true for a range with equal factors (logarithmic axis)
};

/// Cases of a sweep: one study, and for each case the values of some of its entries.
struct CaseList
{
  std::string origin;                               ///< "--vary" or "--cases my.csv", for error messages
  Study base = {};                                  ///< study that provides all other entries
  std::vector<VariedEntry> entries = {};            ///< one or two for a grid, any number from a file
  std::vector<std::vector<std::string>> cases = {}; ///< values [case][entry] as a study file has them, in SI
                                                    ///< units; the last entry of a grid changes fastest

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
///   Motion/Mass=200,250,300 g                   a list; a unit behind the last value only applies to all
///   Motion/Closure=paper,hand,full              words
///
/// Values of a range are rounded to 15 digits of its larger end, so that the middle of -0.3 to 0.3 is 0.
/// Throws BadInput for other texts, unknown entries, inadmissible values and repeated values.
CaseList cases_of_grid(const std::vector<std::string> &varied);

/// Reads cases from a table (parse_table()): one column per entry, "Motion/Mass" or "Motion/Mass (g)", one
/// row per case. Cells may have their own units, and decimal commas unless commas separate them. Throws
/// BadInput that names line and column.
CaseList cases_from_file(const std::string &file);

} // namespace stemware::pipeline
