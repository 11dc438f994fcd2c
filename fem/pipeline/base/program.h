#pragma once

#include <string>

namespace stemware::pipeline
{

/// Version of the program, as in CMakeLists.txt.
std::string program_version();

/// `git describe` of the sources when the program was built, "unknown" without git.
std::string program_revision();

} // namespace stemware::pipeline
