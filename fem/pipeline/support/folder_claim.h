#pragma once

#include <filesystem>

namespace stemware::pipeline
{

/// A folder that a running process works in, marked so that others can see it: a lock of the system on the
/// folder (flock), which ends with the process however that ends.
class FolderClaim
{
public:
  FolderClaim() = default;
  ~FolderClaim();
  FolderClaim(FolderClaim &&other) noexcept;
  FolderClaim &operator=(FolderClaim &&other) noexcept;

  /// Claims an existing folder. Not held when another process has it, when it is gone, or where the file
  /// system knows no such locks.
  explicit FolderClaim(const std::filesystem::path &folder);

  bool held() const { return descriptor >= 0; }

private:
  int descriptor = -1;
};

} // namespace stemware::pipeline
