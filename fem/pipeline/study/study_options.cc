#include "fem/pipeline/study/study_options.h"

namespace stemware::pipeline
{

std::filesystem::path StudyOptions::results_place() const
{
  if (!output.empty())
    return output;
  std::filesystem::path name = std::filesystem::path(study_file).stem();
  if (verb != "run")
    name += "-" + verb;
  return "results" / name;
}

} // namespace stemware::pipeline
