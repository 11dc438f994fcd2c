#pragma once

#include "fem/pipeline/analysis/sweep/case_list.h"
#include "fem/pipeline/analysis/sweep/sweep_case.h"
#include "fem/pipeline/document/table.h"

#include <filesystem>
#include <string>
#include <vector>

namespace stemware::pipeline
{

/// Columns of sweep.csv: case (from 1), the varied entries by their paths, sweep_keys(), contact_outcome,
/// status, message.
std::vector<Quantity> sweep_columns(const CaseList &list);

/// Files that a sweep has in its folder from its first moment on:
///
///   study.json   program, study, columns of sweep.csv, check sums of the files that cases read
///   sweep.csv    a row for each finished case, in the order in which cases finish, sorted at the end
///
/// A row is written whole, so that a killed program leaves at most its last line unfinished; that line is
/// dropped when the sweep goes on. A lock of the system on sweep.csv keeps a second process out and ends with
/// the process.
class SweepFile
{
public:
  /// Begins the files, or reads the finished cases of an earlier run of the same sweep. Throws OutputFailure,
  /// with one sentence and with nothing changed, for a folder that require_replaceable() refuses, another
  /// study or other columns, cases that the list does not have, and for a folder in use.
  SweepFile(const std::filesystem::path &wanted, const CaseList &list);
  ~SweepFile();
  SweepFile(const SweepFile &) = delete;
  SweepFile &operator=(const SweepFile &) = delete;

  const FinishedCases &finished() const { return cases; }

  /// Throws OutputFailure if the disk does not take the row.
  void append(std::size_t index, const CaseResult &result);

  /// Puts the rows into the order of the cases.
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
