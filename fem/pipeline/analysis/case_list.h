#pragma once

#include "fem/pipeline/study/study.h"

#include <cstddef>
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

} // namespace stemware::pipeline
