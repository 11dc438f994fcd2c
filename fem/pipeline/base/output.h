#pragma once

#include <filesystem>
#include <string>

namespace stemware::pipeline
{

/// Mark in the first lines of a page or mesh that Stemware wrote: a later run may overwrite such a file.
inline constexpr char written_by_stemware[] = "written by Stemware";
/// Name of the file in a results folder that lists the files that Stemware wrote there.
inline constexpr char stamp_name[] = ".stemware";

/// Throws OutputFailure, which names the first of the user's files, unless @p folder is missing or has only
/// files of its stamp, hidden files and files of the operating system.
void require_replaceable(const std::filesystem::path &folder);

/// Results folder that appears under its name when it is complete; until then it is "NAME.partial-PID".
class ResultsFolder
{
public:
  /// Throws OutputFailure on every rank, before the work, if @p wanted is not replaceable or not writable.
  explicit ResultsFolder(const std::filesystem::path &wanted);
  ~ResultsFolder();
  ResultsFolder(const ResultsFolder &) = delete;
  ResultsFolder &operator=(const ResultsFolder &) = delete;

  void open(); ///< creates the partial folder, the same on every rank; collective
  const std::filesystem::path &working_folder() const { return partial; } ///< after open()
  bool made_parent = false; ///< the folder of `target` did not exist before
  const std::filesystem::path &final_folder() const { return target; }

  /// Renames the partial folder and removes older results but no hidden files; on the first rank only. Throws
  /// OutputFailure, with older and new results kept, if the target is no longer replaceable.
  void publish();

private:
  const std::filesystem::path target;
  std::filesystem::path partial; ///< removed by the destructor; empty if there is none
};

/// Throws OutputFailure unless @p file is writable, and missing or a file marked @ref written_by_stemware.
void require_writable(const std::filesystem::path &file);

/// Writes a single file, which appears when it is complete. Throws OutputFailure.
void write_output_file(const std::filesystem::path &file, const std::string &text);

} // namespace stemware::pipeline
