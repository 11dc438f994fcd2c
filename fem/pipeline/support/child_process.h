#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <sys/types.h>
#include <vector>

namespace stemware::pipeline
{

/// The first executable file of this name in the folders of PATH.
std::optional<std::filesystem::path> find_program(const std::string &name);

/// A program that runs beside this one in a folder of its own, reads nothing, and whose standard error is
/// kept. It does not outlive this program where that is interrupted, nor this object.
class ChildProcess
{
public:
  /// Starts @p command, the path of a program and its arguments. Throws std::system_error.
  ChildProcess(const std::vector<std::string> &command, const std::filesystem::path &folder);
  ~ChildProcess();
  ChildProcess(const ChildProcess &) = delete;
  ChildProcess &operator=(const ChildProcess &) = delete;

  struct Ended
  {
    int exit_status = 0;  ///< 128 + number for a signal that killed it
    std::string messages; ///< standard error
  };

  /// Waits for the end; to be called once.
  Ended wait();

private:
  pid_t process = -1;
  int messages = -1; ///< end of a pipe
};

} // namespace stemware::pipeline
