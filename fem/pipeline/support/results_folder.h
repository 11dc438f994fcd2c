#pragma once

#include "fem/pipeline/support/folder_claim.h"

#include <filesystem>
#include <string>
#include <vector>

namespace stemware::pipeline
{

/// A folder of results that appears under its name whole or not at all.
///
/// Everything is written into a hidden folder beside it, ".<name>.partial-<pid>", which publish() renames.
/// Until then it goes away with the object, and on interruption; only SIGKILL can leave it behind, until the
/// next one for the same target removes it. An older folder of results is replaced, anything else is left
/// alone: a folder is one of results when its summary.json lists all that is in it under "files".
class ResultsFolder
{
public:
  /// Claims the place before any long work. Throws OutputFailure, with one sentence, when @p target is taken
  /// or cannot be written.
  explicit ResultsFolder(const std::filesystem::path &target);
  ~ResultsFolder();
  ResultsFolder(const ResultsFolder &) = delete;
  ResultsFolder &operator=(const ResultsFolder &) = delete;

  /// Where the results are written for now.
  const std::filesystem::path &working_folder() const { return partial; }

  /// Where they will be.
  const std::filesystem::path &final_folder() const { return target; }

  /// Names of what is in the working folder, sorted; to be listed in summary.json.
  std::vector<std::string> contents() const;

  /// Gives the folder its name. Throws OutputFailure when that fails; the older results are then still there.
  void publish();

private:
  void remove_partial() noexcept;

  std::filesystem::path target;
  std::filesystem::path partial;
  FolderClaim claim;                                  ///< on the working folder
  std::vector<std::filesystem::path> created_parents; ///< innermost first
  bool published = false;
};

} // namespace stemware::pipeline
