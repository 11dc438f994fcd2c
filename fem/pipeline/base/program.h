#pragma once

#include <string>

namespace stemware::pipeline
{

/// Returns the version of the program, as in CMakeLists.txt.
std::string program_version();

/// Returns `git describe` of the sources when the program was built, "unknown" without git.
std::string program_revision();

} // namespace stemware::pipeline
