#pragma once

#include "fem/pipeline/analysis/sweep/sweep_case.h"

#include <chrono>
#include <filesystem>
#include <map>
#include <set>

namespace stemware::pipeline
{

/// Finished cases by their number, from 0.
using FinishedCases = std::map<std::size_t, CaseResult>;

/// A file that grows by one line of JSON for every finished case, in the order in which they are finished.
///
/// A line is written whole, so that a program that is killed leaves at most its last line unfinished; the
/// disk is told to keep the lines at least once a second. For one thread at a time.
class CaseLog
{
public:
  /// Goes on with the file, or begins it. Throws OutputFailure.
  explicit CaseLog(const std::filesystem::path &file);
  ~CaseLog();
  CaseLog(const CaseLog &) = delete;
  CaseLog &operator=(const CaseLog &) = delete;

  /// Throws OutputFailure when the disk does not take the line.
  void append(std::size_t index, const CaseResult &result);

private:
  const std::filesystem::path file;
  int descriptor = -1;
  std::chrono::steady_clock::time_point last_sync;
};

/// The cases of a log, read to the last digit. What does not read as a case, a half-written last line, is cut
/// off with all that follows it. A file that is not there holds no cases. Throws OutputFailure when the file
/// cannot be cut.
FinishedCases recover_cases(const std::filesystem::path &log);

/// How many cases are finished, and how many of them have failed.
struct CaseCount
{
  std::size_t n_finished = 0;
  std::size_t n_failed = 0;
};

/// Counts the cases of logs that grow, of which only what is new is read each time. The logs need not be
/// there yet.
class LogCounter
{
public:
  explicit LogCounter(const std::set<std::filesystem::path> &logs)
  {
    for (const std::filesystem::path &log : logs)
      n_bytes[log] = 0;
  }

  const CaseCount &count();

private:
  std::map<std::filesystem::path, std::uintmax_t> n_bytes; ///< of whole lines, by log
  CaseCount cases;
};

} // namespace stemware::pipeline
