#pragma once

#include <string>
#include <vector>

namespace stemware::pipeline
{

/// What `stemware run` was told.
struct RunOptions
{
  std::string study_file;
  std::string output;                 ///< empty: results/<stem of the study file>
  std::vector<std::string> overrides; ///< "Section/Entry=value"
};

/// Runs a study from its file to the folder of its results. Collective over all ranks.
/// Throws BadInput, OutputFailure, ContactFailure or, for what nobody foresaw, any other exception.
void run(const RunOptions &options);

} // namespace stemware::pipeline
