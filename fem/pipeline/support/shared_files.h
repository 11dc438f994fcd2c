#pragma once

#include <filesystem>
#include <vector>

namespace stemware::pipeline
{

/// Where files that come with the program may lie: ../share/stemware from the folder of its executable, and
/// share/stemware in that folder (as in a build). Empty where the system does not say where that is.
std::vector<std::filesystem::path> shared_folders();

} // namespace stemware::pipeline
