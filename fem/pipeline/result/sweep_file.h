#pragma once

#include "fem/pipeline/analysis/sweep_case.h"

#include <filesystem>
#include <fstream>
#include <string>

namespace stemware::pipeline
{

/// sweep.csv in the folder of a sweep: lines that begin with # (version, base study, size and time of input
/// files), headings with units (case, varied entries, sweep_columns(), contact_outcome, status, message), and
/// a row per finished case, in the order of finishing. Each row is flushed: a killed program leaves at most
/// an incomplete last line, which is dropped when the sweep is continued.
class SweepFile
{
public:
  /// Creates the file, or reads the finished cases of an earlier run. Throws OutputFailure and changes
  /// nothing if require_replaceable() rejects the folder, if version, base study, input files or columns
  /// differ from the earlier run, or if a row is no case of the list.
  SweepFile(const std::filesystem::path &wanted, const CaseList &list);

  const FinishedCases &finished() const { return cases; }

  /// Appends the row of a case. Throws OutputFailure if it cannot be written.
  void append(std::size_t index, const CaseResult &result);

private:
  void read_rows(const std::string &text);
  void write(const std::string &text);

  const std::filesystem::path folder, file;
  const CaseList &list;
  FinishedCases cases;
  std::ofstream stream;
};

} // namespace stemware::pipeline
