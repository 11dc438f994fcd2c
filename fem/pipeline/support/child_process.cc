#include "fem/pipeline/support/child_process.h"

#include "fem/pipeline/support/interruption.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <spawn.h>
#include <sstream>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>

extern char **environ;

namespace stemware::pipeline
{

namespace fs = std::filesystem;

namespace
{

/// posix_spawn, which Open MPI bears in a running program where fork may harm its registered memory.
pid_t spawn(const std::vector<std::string> &command, const fs::path &folder, int standard_error)
{
  std::vector<char *> arguments;
  for (const std::string &word : command)
    arguments.push_back(const_cast<char *>(word.c_str()));
  arguments.push_back(nullptr);

  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, standard_error, STDERR_FILENO);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t no_signals;
  sigemptyset(&no_signals);
  posix_spawnattr_setsigmask(&attributes, &no_signals);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK);

  pid_t process = -1;
  const int error =
    posix_spawn(&process, command.front().c_str(), &actions, &attributes, arguments.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0)
    throw std::system_error(error, std::generic_category(), "cannot start " + command.front());
  return process;
}

std::string read_all(int file)
{
  std::string text;
  std::array<char, 4096> buffer;
  for (;;)
  {
    const auto n_read = ::read(file, buffer.data(), buffer.size());
    if (n_read > 0)
      text.append(buffer.data(), static_cast<std::size_t>(n_read));
    else if (n_read == 0 || errno != EINTR)
      return text;
  }
}

} // namespace

std::optional<fs::path> find_program(const std::string &name)
{
  const char *path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');)
  {
    const fs::path file = fs::absolute(fs::path(folder.empty() ? "." : folder) / name);
    std::error_code error;
    if (fs::is_regular_file(file, error) && ::access(file.c_str(), X_OK) == 0)
      return file;
  }
  return std::nullopt;
}

ChildProcess::ChildProcess(const std::vector<std::string> &command, const fs::path &folder)
{
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0)
    throw std::system_error(errno, std::generic_category(), "cannot listen to " + command.front());
  messages = ends[0];
  const auto lock = postpone_interruption();
  try
  {
    process = spawn(command, folder, ends[1]);
    ::close(ends[1]);
  }
  catch (...)
  {
    ::close(ends[0]);
    ::close(ends[1]);
    throw;
  }
  kill_on_interruption(process);
}

ChildProcess::~ChildProcess()
{
  if (process > 0)
  {
    ::kill(process, SIGKILL);
    wait();
  }
  ::close(messages);
}

ChildProcess::Ended ChildProcess::wait()
{
  Ended ended;
  ended.messages = read_all(messages);
  // The process keeps its number until it is reaped: an interruption meanwhile hits nobody else.
  siginfo_t information = {};
  while (::waitid(P_PID, static_cast<id_t>(process), &information, WEXITED | WNOWAIT) != 0 && errno == EINTR)
    ;
  const auto lock = postpone_interruption();
  int status = 0;
  ::waitpid(process, &status, 0);
  spare_on_interruption(process);
  process = -1;
  ended.exit_status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return ended;
}

} // namespace stemware::pipeline
