#include "fem/pipeline/support/folder_claim.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace stemware::pipeline
{

namespace
{

/// Whether the folder is still the one that was opened: another process may have removed it in between.
bool is_at(const std::filesystem::path &folder, int descriptor)
{
  struct stat opened = {}, present = {};
  return ::fstat(descriptor, &opened) == 0 && ::stat(folder.c_str(), &present) == 0 &&
         opened.st_ino == present.st_ino && opened.st_dev == present.st_dev;
}

} // namespace

FolderClaim::FolderClaim(const std::filesystem::path &folder)
    : descriptor(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC))
{
  if (descriptor < 0)
    return;
  if (::flock(descriptor, LOCK_EX | LOCK_NB) == 0 && is_at(folder, descriptor))
    return;
  ::close(descriptor);
  descriptor = -1;
}

FolderClaim::~FolderClaim()
{
  if (descriptor >= 0)
    ::close(descriptor);
}

FolderClaim::FolderClaim(FolderClaim &&other) noexcept
    : descriptor(std::exchange(other.descriptor, -1))
{
}

FolderClaim &FolderClaim::operator=(FolderClaim &&other) noexcept
{
  std::swap(descriptor, other.descriptor);
  return *this;
}

} // namespace stemware::pipeline
