#include "fem/pipeline/study/study_options.h"

namespace stemware::pipeline
{

std::string StudyOptions::study_name() const
{
  return study_file.empty()  ? "default"
         : study_file == "-" ? "stdin"
                             : std::filesystem::path(study_file).stem().string();
}

std::filesystem::path StudyOptions::results_place() const
{
  if (!output.empty())
    return output;
  std::string name = study_name();
  if (verb != "run")
    name += "-" + verb;
  return std::filesystem::path("results") / name;
}

} // namespace stemware::pipeline
