#include "fem/pipeline/support/child_process.h"

#include <boost/algorithm/string/replace.hpp>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>

namespace stemware::pipeline
{

namespace fs = std::filesystem;

namespace
{

/// A word that the shell takes as it stands.
std::string quoted(const std::string &word)
{
  return "'" + boost::replace_all_copy(word, "'", R"('\'')") + "'";
}

std::FILE *start(const std::vector<std::string> &command, const fs::path &folder)
{
  std::string line = "cd " + quoted(fs::absolute(folder)) + " && exec";
  for (const std::string &word : command)
    line += " " + quoted(word);
  line += " 2>&1 >/dev/null </dev/null";
  // Not fork(), which may harm memory that Open MPI has registered: the C library starts the shell by
  // vfork().
  std::FILE *const messages = ::popen(line.c_str(), "re");
  if (messages == nullptr)
    throw std::system_error(errno, std::generic_category(), "cannot start " + command.front());
  return messages;
}

EndedProgram wait_for(std::FILE *messages)
{
  EndedProgram ended;
  std::array<char, 4096> buffer;
  while (const std::size_t n_read = std::fread(buffer.data(), 1, buffer.size(), messages))
    ended.messages.append(buffer.data(), n_read);
  const int status = ::pclose(messages);
  ended.exit_status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return ended;
}

} // namespace

bool has_program(const std::string &name)
{
  return std::system(("command -v " + name + " >/dev/null 2>&1").c_str()) == 0;
}

std::vector<EndedProgram> run_programs(const std::vector<std::vector<std::string>> &commands,
                                       const fs::path &folder)
{
  std::vector<std::FILE *> running;
  for (const std::vector<std::string> &command : commands)
    running.push_back(start(command, folder));
  std::vector<EndedProgram> ended;
  for (std::FILE *messages : running)
    ended.push_back(wait_for(messages));
  return ended;
}

} // namespace stemware::pipeline
