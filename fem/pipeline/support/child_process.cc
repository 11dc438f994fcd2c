#include "fem/pipeline/support/child_process.h"

#include "fem/pipeline/support/interruption.h"

#include <boost/algorithm/string/replace.hpp>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>

namespace stemware::pipeline
{

namespace fs = std::filesystem;

namespace
{

struct RunningProgram
{
  std::FILE *messages = nullptr; ///< of popen()
  pid_t process = -1;
};

/// A word that the shell takes as it stands.
std::string quoted(const std::string &word)
{
  return "'" + boost::replace_all_copy(word, "'", R"('\'')") + "'";
}

RunningProgram start(const std::vector<std::string> &command, const fs::path &folder)
{
  // The shell tells its number, which is that of the program once that has taken its place.
  std::string line = "cd " + quoted(fs::absolute(folder)) + " && echo $$ && exec";
  for (const std::string &word : command)
    line += " " + quoted(word);
  line += " 2>&1 >/dev/null </dev/null";
  RunningProgram program;
  const PostponedInterruption postponed;
  // Not fork(), which may harm memory that Open MPI has registered: the C library starts the shell by
  // vfork().
  program.messages = ::popen(line.c_str(), "re");
  if (program.messages == nullptr || std::fscanf(program.messages, "%d%*c", &program.process) != 1)
    throw std::system_error(errno, std::generic_category(), "cannot start " + command.front());
  postponed->children.insert(program.process);
  return program;
}

EndedProgram wait_for(const RunningProgram &program)
{
  EndedProgram ended;
  std::array<char, 4096> buffer;
  while (const std::size_t n_read = std::fread(buffer.data(), 1, buffer.size(), program.messages))
    ended.messages.append(buffer.data(), n_read);
  // An interruption between the two would hit whoever has got the number of the process by then.
  const PostponedInterruption postponed;
  const int status = ::pclose(program.messages);
  postponed->children.erase(program.process);
  ended.exit_status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return ended;
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

std::vector<EndedProgram> run_programs(const std::vector<std::vector<std::string>> &commands,
                                       const fs::path &folder)
{
  std::vector<RunningProgram> running;
  for (const std::vector<std::string> &command : commands)
    running.push_back(start(command, folder));
  std::vector<EndedProgram> ended;
  for (const RunningProgram &program : running)
    ended.push_back(wait_for(program));
  return ended;
}

} // namespace stemware::pipeline
