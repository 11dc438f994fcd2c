#pragma once

#include "tests/fem/scratch_folder.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <map>
#include <string>
#include <sys/types.h>
#include <vector>

namespace stemware::test
{

/// Exit code and output of a program.
struct Ended
{
  int exit_code = -1; ///< 128 + number for a signal that killed it
  std::string out;    ///< standard output
  std::string err;    ///< standard error
};

/// A running program, whose standard output and error are the files .out and .err in its folder.
class RunningProgram
{
public:
  RunningProgram(const std::vector<std::string> &command, const std::filesystem::path &folder);

  /// Waits until the program has printed @p text on standard output. Returns false if the program ends
  /// before.
  bool wait_for_output(const std::string &text) const;

  void send(int signal) const;

  /// Waits for the end; to be called once. Kills the program after five minutes, so that no hanging process
  /// is left.
  Ended end();

private:
  std::filesystem::path folder;
  pid_t process = -1;
};

/// Runs the program `stemware` in the folder with these arguments.
Ended stemware(const ScratchFolder &scratch, const std::vector<std::string> &arguments);

/// Returns @p command with --set before each of @p settings.
std::vector<std::string> with_settings(std::vector<std::string> command,
                                       const std::vector<std::string> &settings);

/// Runs a command with settings and output in the folder @p results, expects success, and returns its
/// summary.
nlohmann::json solved(const ScratchFolder &scratch, const std::vector<std::string> &command,
                      const std::vector<std::string> &settings = {}, const std::string &results = "results");

std::string read_text(const std::filesystem::path &file);

/// Returns the text between @p begin and the next @p end in @p text; empty if @p begin is missing.
std::string between(const std::string &text, const std::string &begin, const std::string &end);

/// Returns the texts between every @p begin and the next @p end.
std::vector<std::string> all_between(const std::string &text, const std::string &begin,
                                     const std::string &end);

/// Returns lines that are too wide for the console or contain escape codes.
std::string bad_lines(const std::string &text);

/// Returns the violations of summary_schema() in a summary, one sentence each.
std::vector<std::string> departures_from_schema(const nlohmann::json &summary);

/// Returns the summary of a results folder; a violation of the schema fails the test.
nlohmann::json read_summary(const std::filesystem::path &results);

/// Returns the columns of a results table as numbers; CSV, or columns separated by blanks.
std::vector<std::vector<double>> read_columns(const std::filesystem::path &table);

/// Returns the contents of all files below a folder by relative path, without timings.json, which differs
/// between runs.
std::map<std::string, std::string> all_files(const std::filesystem::path &folder);

/// Returns the sorted names in a folder, including hidden files, without .stemware, .out and .err.
std::vector<std::string> names_in(const std::filesystem::path &folder);

/// Returns a study that runs in a second: step profile, no friction coupling, no tilt, load at rest for every
/// spin. @p further lines are appended.
std::string plain_study(const std::string &further = "");

/// Returns the plain study with a solid body on a coarse mesh.
std::string coarse_study(const std::string &further = "");

} // namespace stemware::test
