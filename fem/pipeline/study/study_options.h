#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace stemware::pipeline
{

/// Options of every verb that works on a study.
struct StudyOptions
{
  std::string verb;                   ///< name of the verb, "run"
  std::string study_file;             ///< empty: the default study; "-": standard input
  std::string output;                 ///< folder of --output; empty: the default folder
  std::vector<std::string> overrides; ///< "Section/Entry=value", of --set
  unsigned int n_threads = 0;         ///< threads that share the work; 0: number of cores
  bool quiet = false;                 ///< console shows failures only
  bool json = false;                  ///< standard output has one JSON object only

  /// Returns the stem of the study file, "default" without a file, "stdin" for standard input.
  std::string study_name() const
  {
    return study_file.empty()  ? "default"
           : study_file == "-" ? "stdin"
                               : std::filesystem::path(study_file).stem().string();
  }

  /// Returns --output, else results/NAME for `run` and results/NAME-VERB for other verbs; NAME: study_name().
  std::filesystem::path results_place() const
  {
    const std::string of_verb = verb == "run" ? "" : "-" + verb;
    return output.empty() ? "results/" + study_name() + of_verb : output;
  }
};

} // namespace stemware::pipeline
