#pragma once

#include "fem/pipeline/support/folders.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace stemware::pipeline
{

/// Name of the file in which a folder of results lists its files, so that nothing else is ever replaced or
/// removed: {"program": "stemware", "files": {"load.dat": {"bytes": 123, "crc64": "..."}, ...}}. Files in
/// folders below are listed by their relative path, the manifest itself is not.
extern const char *const manifest_name;

/// Writes the manifest of all files that are in @p folder now. Files of sealed_text() are listed without size
/// and check sum, so that equal runs have equal manifests. Throws OutputFailure,
/// std::filesystem::filesystem_error.
void write_manifest(const std::filesystem::path &folder);

/// Obstacle to replacing @p folder, as the end of a sentence that begins with the folder: "holds
/// figures/note.txt, which is not a result of Stemware". Nothing where the folder is empty, or holds only
/// files that its manifest lists, each as it was written. Links are not followed. Throws
/// std::filesystem::filesystem_error.
std::optional<std::string> why_not_replaceable(const std::filesystem::path &folder);

/// Refuses a place for results where anything would be lost: throws OutputFailure, with one sentence, where
/// @p target is neither missing nor an empty folder nor one of results, all of whose files are listed in its
/// manifest.json with the size and check sum that they have.
void require_replaceable(const std::filesystem::path &target);

/// A folder of results that appears under its name whole or not at all. All ranks make one together; the
/// first one owns it.
///
/// Everything is written into a new hidden folder beside it, ".<name>.partial-<pid>-<random digits>", which
/// publish() renames. Until then it goes away with the object, and on interruption; only SIGKILL can leave it
/// behind, until the next one for the same target removes it, if nothing is in it but what its manifest
/// lists. An older folder of results is replaced under the same condition; anything else is left alone.
class ResultsFolder
{
public:
  /// Claims the place before any long work. Throws OutputFailure on every rank, with one sentence, when @p
  /// target is not replaceable or cannot be written.
  explicit ResultsFolder(const std::filesystem::path &target);
  ~ResultsFolder();
  ResultsFolder(const ResultsFolder &) = delete;
  ResultsFolder &operator=(const ResultsFolder &) = delete;

  /// Where the results are written for now; the same on every rank.
  const std::filesystem::path &working_folder() const { return partial; }

  /// Where they will be.
  const std::filesystem::path &final_folder() const { return target; }

  /// Names of what is in the working folder, sorted, the manifest among them; to be listed in summary.json.
  std::vector<std::string> contents() const { return names_in(partial); }

  /// Gives the folder its name; on the first rank only. Throws OutputFailure when that fails, or when the
  /// target is no longer replaceable; the older results are then still there.
  void publish();

private:
  void claim_place();
  void remove_partial() noexcept;

  std::filesystem::path target;
  std::filesystem::path partial;
  FolderClaim claim;                                  ///< on the working folder
  std::vector<std::filesystem::path> created_parents; ///< innermost first
  bool published = false;
};

} // namespace stemware::pipeline
