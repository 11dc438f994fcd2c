#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace stemware::pipeline
{

/// Whether the shell finds a program of that name.
bool has_program(const std::string &name);

/// How a program has ended.
struct EndedProgram
{
  int exit_status = 0;  ///< 128 + number for a signal that killed it
  std::string messages; ///< standard error
};

/// Runs @p commands, each a program and its arguments, side by side in @p folder, and waits for
/// all of them. They read nothing. Throws std::system_error.
std::vector<EndedProgram> run_programs(const std::vector<std::vector<std::string>> &commands,
                                       const std::filesystem::path &folder);

} // namespace stemware::pipeline
