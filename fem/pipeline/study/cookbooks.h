#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace stemware::pipeline
{

/// Names of the studies that come with the program, sorted; none where they are not installed.
std::vector<std::string> cookbook_names();

/// A file that belongs to a study.
struct StudyPart
{
  std::filesystem::path file; ///< where it is to be written
  std::string text;
};

/// The study of that cookbook as the file @p file, first, and the files that it reads, which belong beside
/// it: the study names them so. Throws BadInput for a name that there is not, with those that there are, and
/// where the cookbooks are not installed, with the folders in which they would be.
std::vector<StudyPart> cookbook_parts(const std::string &name, const std::filesystem::path &file);

} // namespace stemware::pipeline
