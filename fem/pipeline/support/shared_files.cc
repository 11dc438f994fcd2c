#include "fem/pipeline/support/shared_files.h"

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

} // namespace stemware::pipeline
