#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace stemware::pipeline
{

/// Returns the folders of installed files: ../share/stemware relative to the folder of the executable, and
/// share/stemware in that folder (build tree). Empty if the folder of the executable is unknown.
std::vector<std::filesystem::path> shared_folders();

/// Source file compiled into the program by stemware_compiled_in() of CMakeLists.txt.
struct CompiledText
{
  std::string name; ///< without its folder
  std::string text;
};

/// Compiled-in files, in the order in which CMake was given them.
using CompiledTexts = std::vector<CompiledText>;

/// Returns the text of the file @p name. Throws std::logic_error if it is not compiled in.
const std::string &text_of(const CompiledTexts &files, const std::string &name);

} // namespace stemware::pipeline
