#pragma once

#include <dirent.h>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace stemware::pipeline
{

/// Absolute path without dots, trailing slash and links, so that its parent and name are clear.
std::filesystem::path resolved(const std::filesystem::path &path);

/// Creates the missing folders of a path, and says which those were, innermost first. Throws
/// std::filesystem::filesystem_error.
std::vector<std::filesystem::path> create_folders(const std::filesystem::path &folder);

/// Removes folders that create_folders() has made, up to the first that something else has come into.
void remove_empty_folders(const std::vector<std::filesystem::path> &innermost_first) noexcept;

/// Whether there is a folder of this name itself, not a link to one.
bool is_plain_folder(const std::filesystem::path &path);

/// Whether there is a regular file of this name itself, not a link to one.
bool is_plain_file(const std::filesystem::path &path);

/// Names of all that is in a folder, sorted. Throws std::filesystem::filesystem_error.
std::vector<std::string> names_in(const std::filesystem::path &folder);

/// A folder that a running process works in, marked so that others can see it: a lock of the system on the
/// folder (flock), which ends with the process however that ends.
class FolderClaim
{
public:
  FolderClaim() = default;

  /// Claims an existing folder. Not held when another process has it, when it is gone or a link, or where the
  /// file system knows no such locks.
  explicit FolderClaim(const std::filesystem::path &folder);

  bool held() const { return claimed != nullptr; }

private:
  std::shared_ptr<DIR> claimed; ///< open as long as a copy is
};

} // namespace stemware::pipeline
