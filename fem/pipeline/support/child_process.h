#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace stemware::pipeline
{

/// The first executable file of this name in the folders of PATH.
std::optional<std::filesystem::path> find_program(const std::string &name);

/// How a program has ended.
struct EndedProgram
{
  int exit_status = 0;  ///< 128 + number for a signal that killed it
  std::string messages; ///< standard error
};

/// Runs @p commands, each the path of a program and its arguments, side by side in @p folder, and waits for
/// all of them. They read nothing. Throws std::system_error.
std::vector<EndedProgram> run_programs(const std::vector<std::vector<std::string>> &commands,
                                       const std::filesystem::path &folder);

} // namespace stemware::pipeline
