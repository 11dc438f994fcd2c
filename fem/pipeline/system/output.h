#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace stemware::pipeline
{

/// Mark in the first lines of a page or mesh that Stemware wrote: a later run may overwrite such a file.
inline constexpr char written_by_stemware[] = "written by Stemware";

/// Returns whether a verb of this or an earlier version writes a file @p name into a results folder:
/// "load.csv", "fields/contact.vtu", "figures/load.svg".
bool is_result_name(const std::string &name);

/// Returns the absolute path of an output with all links resolved except the last component. Throws
/// OutputFailure for a path that cannot be resolved or is not UTF-8.
std::filesystem::path resolved_output(const std::filesystem::path &path);

/// Throws OutputFailure unless @p folder is missing, or empty, or contains @p mark and only names that verbs
/// write, to protect the user's files. Links, and folders other than figures and fields, are rejected. Lists
/// names and opens no file.
void require_replaceable(const std::filesystem::path &folder, const std::string &mark = "summary.json");

/// Results folder that appears under its name only when it is complete. Created by all ranks together; the
/// first rank owns it.
///
/// Results are written to the folder "NAME.partial-PID" next to it, which publish() renames; older results
/// are then removed. The partial folder of a killed program stays, and the next run reports it.
class ResultsFolder
{
public:
  /// Checks @p target before long work: creates the partial folder and removes it again. Throws OutputFailure
  /// on every rank if @p target is not replaceable or not writable.
  explicit ResultsFolder(const std::filesystem::path &target);
  ~ResultsFolder();
  ResultsFolder(const ResultsFolder &) = delete;
  ResultsFolder &operator=(const ResultsFolder &) = delete;

  /// Creates the partial folder, the same on every rank. Collective. Throws OutputFailure.
  void open();

  /// The partial folder, after open().
  const std::filesystem::path &working_folder() const { return partial; }

  /// The folder of the results.
  const std::filesystem::path &final_folder() const { return target; }

  /// Renames the partial folder and removes older results; on the first rank only. Throws OutputFailure if
  /// the target is no longer replaceable: older and new results are then kept. Throws std::logic_error for a
  /// file without a result_name().
  void publish();

private:
  void make_partial();
  void remove_partial() noexcept;

  std::filesystem::path target;
  std::filesystem::path partial;                      ///< empty if there is none
  std::vector<std::filesystem::path> created_parents; ///< innermost first
};

/// Throws OutputFailure, before the work, unless a single file can be written: its folder is writable, and an
/// existing file is a plain file marked @ref written_by_stemware.
void require_writable(const std::filesystem::path &file);

/// Writes a single file, which appears under its name when it is complete. Throws OutputFailure as
/// require_writable(), and if the disk is full.
void write_output_file(const std::filesystem::path &file, const std::string &text);

} // namespace stemware::pipeline
