#include "fem/pipeline/support/folders.h"

#include <algorithm>
#include <cerrno>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace stemware::pipeline
{

namespace fs = std::filesystem;

namespace
{

/// Whether the folder is the one that was opened, and no link to it: another process may have removed it in
/// between.
bool is_at(const fs::path &folder, int descriptor)
{
  struct stat opened = {}, present = {};
  return ::fstat(descriptor, &opened) == 0 && ::lstat(folder.c_str(), &present) == 0 &&
         opened.st_ino == present.st_ino && opened.st_dev == present.st_dev;
}

} // namespace

fs::path resolved(const fs::path &path)
{
  std::error_code error;
  fs::path result = fs::weakly_canonical(fs::absolute(path, error), error);
  if (error)
    result = fs::absolute(path).lexically_normal();
  return result.has_filename() ? result : result.parent_path();
}

std::vector<fs::path> create_folders(const fs::path &folder)
{
  std::vector<fs::path> missing;
  std::error_code error;
  for (fs::path path = folder; !path.empty() && !fs::exists(path, error); path = path.parent_path())
    missing.push_back(path);
  fs::create_directories(folder);
  return missing;
}

void remove_empty_folders(const std::vector<fs::path> &innermost_first) noexcept
{
  for (const fs::path &folder : innermost_first)
    if (::rmdir(folder.c_str()) != 0 && errno != ENOENT)
      break;
}

bool is_plain_folder(const fs::path &path)
{
  std::error_code error;
  return fs::symlink_status(path, error).type() == fs::file_type::directory;
}

bool is_plain_file(const fs::path &path)
{
  std::error_code error;
  return fs::symlink_status(path, error).type() == fs::file_type::regular;
}

std::vector<std::string> names_in(const fs::path &folder)
{
  std::vector<std::string> names;
  for (const auto &item : fs::directory_iterator(folder))
    names.push_back(item.path().filename());
  std::sort(names.begin(), names.end());
  return names;
}

FolderClaim::FolderClaim(const fs::path &folder)
{
  DIR *const opened = ::opendir(folder.c_str());
  if (opened == nullptr)
    return;
  claimed = std::shared_ptr<DIR>(opened, [](DIR *claim) { ::closedir(claim); });
  if (::flock(::dirfd(opened), LOCK_EX | LOCK_NB) != 0 || !is_at(folder, ::dirfd(opened)))
    claimed.reset();
}

} // namespace stemware::pipeline
