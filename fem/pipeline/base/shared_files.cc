#include "fem/pipeline/base/shared_files.h"

#include <algorithm>
#include <stdexcept>

namespace stemware::pipeline
{

std::vector<std::filesystem::path> shared_folders()
{
  std::error_code error;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
  if (error)
    return {};
  const std::filesystem::path folder = program.parent_path();
  return { folder.parent_path() / "share/stemware", folder / "share/stemware" };
}

const std::string &text_of(const CompiledTexts &files, const std::string &name)
{
  const auto file =
    std::find_if(files.begin(), files.end(), [&](const CompiledText &each) { return each.name == name; });
  if (file == files.end())
    throw std::logic_error("The program has no text " + name + ".");
  return file->text;
}

} // namespace stemware::pipeline
