#pragma once

#include "fem/pipeline/analysis/sweep/sweep_case.h"
#include "fem/pipeline/support/folders.h"

#include <nlohmann/json.hpp>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <map>
#include <utility>
#include <vector>

namespace stemware::pipeline
{

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

/// Cases of all logs in a folder, those of all ranks.
FinishedCases finished_cases(const std::filesystem::path &folder);

/// How many cases are finished, and how many of them have failed.
struct CaseCount
{
  std::size_t n_finished = 0;
  std::size_t n_failed = 0;
};

/// Counts the cases of the logs in a folder, which grow: only what is new is read each time. The logs need
/// not be there yet.
class LogCounter
{
public:
  explicit LogCounter(std::filesystem::path folder)
      : folder(std::move(folder))
  {
  }

  const CaseCount &count();

private:
  const std::filesystem::path folder;
  std::map<std::filesystem::path, std::uintmax_t> n_bytes; ///< of whole lines, by log
  CaseCount cases;
};

/// The hidden folder ".<name>.sweep" beside the results, in which a sweep keeps its finished cases until the
/// results are whole: plan.json, which says what it is and of which sweep, and a log of cases for each rank.
/// What is in it survives the program, so that the same sweep can go on from there. A folder, or a link, that
/// is anything else is refused, and nothing in it is touched.
///
/// The first rank owns it: only one program at a time.
class SweepFolder
{
public:
  /// Takes the folder, or makes it. @p identity tells sweeps apart: a folder with finished cases of another
  /// one is left alone unless @p restart is set, which throws them away. Throws OutputFailure, with one
  /// sentence, for that, for a folder in use or not of a sweep, and for trouble with files.
  SweepFolder(const std::filesystem::path &results, const nlohmann::ordered_json &identity, bool restart);
  /// Removes the folder if it holds no finished case.
  ~SweepFolder();
  SweepFolder(const SweepFolder &) = delete;
  SweepFolder &operator=(const SweepFolder &) = delete;

  const std::filesystem::path &path() const { return folder; }

  /// The log of one rank in the folder @p path.
  static std::filesystem::path log_of(const std::filesystem::path &path, unsigned int rank);

  /// Removes the plan and the logs, and the folder if nothing else is in it.
  void remove() noexcept;

  /// Removes the folder if it holds no finished case, and folders above it that were made for it; what
  /// interruptions do.
  void remove_if_empty() noexcept;

private:
  void take();
  void require_own() const;
  void adopt(const nlohmann::ordered_json &identity, bool restart);

  const std::filesystem::path results;
  const std::filesystem::path folder;
  std::vector<std::filesystem::path>
    created; ///< the folder and those above it that were made, innermost first
  FolderClaim claim;
};

} // namespace stemware::pipeline
