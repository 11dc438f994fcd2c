#pragma once

#include <map>
#include <string>

namespace stemware::pipeline
{

/// The files of fem/pipeline/report/plots by their names, as they were when the program was compiled.
extern const std::map<std::string, std::string> compiled_plots;

} // namespace stemware::pipeline
