#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

namespace stemware::test
{

/// Temporary folder, removed by the destructor.
class ScratchFolder
{
public:
  ScratchFolder()
  {
    std::string pattern = (std::filesystem::temp_directory_path() / "stemware-test-XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr)
      throw std::runtime_error("cannot create a folder like " + pattern);
    folder = pattern;
  }
  ~ScratchFolder()
  {
    std::error_code error;
    std::filesystem::remove_all(folder, error);
  }
  ScratchFolder(const ScratchFolder &) = delete;
  ScratchFolder &operator=(const ScratchFolder &) = delete;

  std::filesystem::path operator/(const std::string &name) const { return folder / name; }
  const std::filesystem::path &path() const { return folder; }

  std::string write(const std::string &name, const std::string &text) const
  {
    std::filesystem::create_directories((folder / name).parent_path());
    std::ofstream(folder / name, std::ios::binary) << text;
    return (folder / name).string();
  }

private:
  std::filesystem::path folder;
};

/// File in a temporary folder, removed by the destructor.
struct TemporaryFile
{
  explicit TemporaryFile(const std::string &content, const std::string &extension = ".msh")
      : name(folder.write("file" + extension, content))
  {
  }

  const ScratchFolder folder;
  const std::string name;
};

} // namespace stemware::test
