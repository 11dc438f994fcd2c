#pragma once

#include "fem/pipeline/answer/case_list.h"
#include "fem/pipeline/answer/sweep_case.h"
#include "fem/pipeline/document/table.h"

#include <filesystem>
#include <string>
#include <vector>

namespace stemware::pipeline
{

/// Returns the columns of sweep.csv: case (from 1), varied entries by path, sweep_keys(), contact_outcome,
/// status, message.
std::vector<Quantity> sweep_columns(const CaseList &list);

/// Files of a running sweep in its folder:
///
///   study.json   program, study, columns of sweep.csv, check sums of the files that cases read
///   sweep.csv    a row for each finished case, in the order in which cases finish, sorted at the end
///
/// Each row is written at once: a killed program leaves at most its last line incomplete, which is dropped
/// when the sweep continues. A system lock on sweep.csv excludes a second process and ends with the process.
class SweepFile
{
public:
  /// Creates the files, or reads the finished cases of an earlier run of the same sweep. Throws
  /// OutputFailure, with nothing changed, for a folder that require_replaceable() rejects, for another study,
  /// other columns or cases that the list lacks, and for a folder in use.
  SweepFile(const std::filesystem::path &wanted, const CaseList &list);
  ~SweepFile();
  SweepFile(const SweepFile &) = delete;
  SweepFile &operator=(const SweepFile &) = delete;

  const FinishedCases &finished() const { return cases; }

  /// Appends the row of a case. Throws OutputFailure if it cannot be written.
  void append(std::size_t index, const CaseResult &result);

  /// Sorts the rows by case.
  void sort();

private:
  void open();
  void read_rows(const std::string &text);
  void write(const std::string &text);
  std::string row_of(std::size_t index, const CaseResult &result) const;

  const std::filesystem::path folder;
  const CaseList &list;
  const std::string header;
  FinishedCases cases;
  int descriptor = -1;
};

} // namespace stemware::pipeline
