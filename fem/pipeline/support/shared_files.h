#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace stemware::pipeline
{

/// Folders of the files that come with the program: ../share/stemware from the folder of its executable, and
/// share/stemware in that folder (as in a build). Empty if the folder of the executable is unknown.
std::vector<std::filesystem::path> shared_folders();

/// A file of the sources that stemware_compiled_in() of CMakeLists.txt has put into the program.
struct CompiledText
{
  std::string name; ///< without its folder
  std::string text;
};

/// Compiled-in files, in the order in which CMake was given them.
using CompiledTexts = std::vector<CompiledText>;

/// The text of the file @p name. Throws std::logic_error where there is none: the program names its own.
const std::string &text_of(const CompiledTexts &files, const std::string &name);

} // namespace stemware::pipeline
