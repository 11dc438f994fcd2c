#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace stemware::pipeline
{

/// Mark in the first lines of a page or mesh that Stemware wrote: a later run may overwrite such a file.
inline constexpr char written_by_stemware[] = "written by Stemware";

/// True if verbs, or those of an earlier version, write a file of that name into a folder of results:
/// "load.csv", "fields/contact.vtu", "figures/load.svg".
bool is_result_name(const std::string &name);

/// Absolute path of an output, with all links resolved but one in the last place. Throws OutputFailure, with
/// one sentence, for a path that cannot be resolved or is no UTF-8.
std::filesystem::path resolved_output(const std::filesystem::path &path);

/// Refuses a folder in which something of the user's could be lost: throws OutputFailure, with one sentence,
/// unless @p folder is missing, or empty, or holds @p mark and no name that verbs do not write. Links, and
/// folders other than figures and fields, are such names. Lists names and opens no file.
void require_replaceable(const std::filesystem::path &folder, const std::string &mark = "summary.json");

/// A folder of results that appears under its name whole or not at all. All ranks make one together; the
/// first rank owns it.
///
/// Results are written to the new folder "NAME.partial-PID" beside it, which publish() renames. Older results
/// are removed after that. If the program is killed meanwhile, the partial folder stays; the next run names
/// it.
class ResultsFolder
{
public:
  /// Checks the place before any long work: makes the partial folder and removes it again. Throws
  /// OutputFailure on every rank, with one sentence, if @p target is not replaceable or cannot be written.
  explicit ResultsFolder(const std::filesystem::path &target);
  ~ResultsFolder();
  ResultsFolder(const ResultsFolder &) = delete;
  ResultsFolder &operator=(const ResultsFolder &) = delete;

  /// Makes the partial folder; the same path on every rank. Collective. Throws OutputFailure.
  void open();

  /// The partial folder, after open().
  const std::filesystem::path &working_folder() const { return partial; }

  /// The folder of the results.
  const std::filesystem::path &final_folder() const { return target; }

  /// Gives the folder its name and removes older results; on the first rank only. Throws OutputFailure if the
  /// place is not replaceable any more: the older and the new results are then both there. Throws
  /// std::logic_error for a file whose name is not a result_name().
  void publish();

private:
  void make_partial();
  void remove_partial() noexcept;

  std::filesystem::path target;
  std::filesystem::path partial;                      ///< empty if there is none
  std::vector<std::filesystem::path> created_parents; ///< innermost first
};

/// Refuses a place for a file that stands alone, before the work: throws OutputFailure, with one sentence,
/// if there is anything but a plain file marked @ref written_by_stemware, or if its folder cannot be written.
void require_writable(const std::filesystem::path &file);

/// Writes a file that stands alone: it appears under its name when it is complete. Throws OutputFailure as
/// require_writable(), and if the disk is full.
void write_output_file(const std::filesystem::path &file, const std::string &text);

} // namespace stemware::pipeline
