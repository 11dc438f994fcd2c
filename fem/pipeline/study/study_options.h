#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace stemware::pipeline
{

/// Options of every verb that works on a study.
struct StudyOptions
{
  std::string verb;                   ///< its name, "run"
  std::string study_file;             ///< empty: the default study; "-": standard input
  std::string output;                 ///< folder of --output; empty: the default folder
  std::vector<std::string> overrides; ///< "Section/Entry=value", of --set
  unsigned int n_threads = 0;         ///< threads that share the work; 0: number of cores
  bool quiet = false;                 ///< nothing on the console but failures
  bool json = false;                  ///< standard output holds one JSON object and nothing else

  /// Returns the stem of the study file, "default" without a file, "stdin" for standard input.
  std::string study_name() const
  {
    return study_file.empty()  ? "default"
           : study_file == "-" ? "stdin"
                               : std::filesystem::path(study_file).stem().string();
  }

  /// Returns the folder of the results: --output, else results/<name of the study> for `run` and
  /// results/<name of the study>-<verb> for the other verbs.
  std::filesystem::path results_place() const
  {
    const std::string of_verb = verb == "run" ? "" : "-" + verb;
    return output.empty() ? "results/" + study_name() + of_verb : output;
  }
};

} // namespace stemware::pipeline
