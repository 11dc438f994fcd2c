#pragma once

#include "fem/pipeline/analysis/sweep/case_log.h"
#include "fem/pipeline/support/folders.h"

#include <nlohmann/json.hpp>

namespace stemware::pipeline
{

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

  /// A counter for the logs in that folder, and for those that @p n_ranks ranks will write.
  static LogCounter logs_in(const std::filesystem::path &path, unsigned int n_ranks);

  /// Cases that all ranks have finished so far.
  FinishedCases finished_cases() const;

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
