#pragma once

#include <filesystem>
#include <string>

namespace stemware::pipeline
{
/// Text in the first lines of each page and mesh written by Stemware: a later run may overwrite the file.
inline constexpr char written_by_stemware[] = "written by Stemware";
/// Name of the file in a results folder that lists the files written by Stemware.
inline constexpr char stamp_name[] = ".stemware";

/// Throws OutputFailure unless @p folder is missing, or holds only files listed in its file stamp_name,
/// hidden files and files of the operating system. Names the first other file.
void require_replaceable(const std::filesystem::path &folder);

/// Results folder, written as "NAME.partial-PID" and renamed to NAME when it is complete.
class ResultsFolder
{
public:
  /// Throws OutputFailure on every rank, before the work, if @p wanted is not replaceable or not writable.
  explicit ResultsFolder(const std::filesystem::path &wanted);
  ~ResultsFolder();
  ResultsFolder(const ResultsFolder &) = delete;
  ResultsFolder &operator=(const ResultsFolder &) = delete;

  void open(); ///< creates the partial folder, the same on every rank; collective
  const std::filesystem::path &working_folder() const { return partial; } ///< valid after open()
  const std::filesystem::path &final_folder() const { return target; }

  /// Renames the partial folder and removes older results but no hidden files; on the first rank only. Throws
  /// OutputFailure, and keeps older and new results, if require_replaceable() rejects final_folder().
  void publish();

private:
  const std::filesystem::path target;
  std::filesystem::path partial; ///< removed by the destructor; empty if there is none
  bool made_parent = false;      ///< true if the parent of the results folder was created
};

/// Throws OutputFailure unless @p file is writable, and missing or marked with written_by_stemware.
void require_writable(const std::filesystem::path &file);

/// Writes @p file under another name and renames it when it is complete. Throws OutputFailure.
void write_output_file(const std::filesystem::path &file, const std::string &text);
} // namespace stemware::pipeline
