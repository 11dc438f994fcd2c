#pragma once

#include "tests/fem/pipeline/scratch_folder.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <map>
#include <string>
#include <sys/types.h>
#include <vector>

namespace stemware::test
{

/// What a program has left behind when it has ended.
struct Ended
{
  int exit_code = -1; ///< 128 + number for a signal that killed it
  std::string out;    ///< standard output
  std::string err;    ///< standard error
};

/// A program that runs in its own folder, which holds its standard output and error as the files .out and
/// .err.
class RunningProgram
{
public:
  RunningProgram(const std::vector<std::string> &command, const std::filesystem::path &folder);

  /// Waits until the program has printed @p text on standard output; false when it ends, or a minute passes,
  /// before that.
  bool wait_for_output(const std::string &text) const;

  void send(int signal) const;

  /// Waits for the end; to be called once. A program that hangs for five minutes is killed.
  Ended end();

private:
  std::filesystem::path folder;
  pid_t process = -1;
};

/// Runs the program `stemware` in the folder with these arguments.
Ended stemware(const ScratchFolder &scratch, const std::vector<std::string> &arguments);

/// A command with --set before each of @p settings.
std::vector<std::string> with_settings(std::vector<std::string> command,
                                       const std::vector<std::string> &settings);

/// Runs a command with settings, which has to succeed, into the folder @p results; returns its summary.
nlohmann::json solved(const ScratchFolder &scratch, const std::vector<std::string> &command,
                      const std::vector<std::string> &settings = {}, const std::string &results = "results");

std::string read_text(const std::filesystem::path &file);

/// What stands between @p begin and the next @p end in @p text; empty where there is no such place.
std::string between(const std::string &text, const std::string &begin, const std::string &end);

/// The same after every @p begin.
std::vector<std::string> all_between(const std::string &text, const std::string &begin,
                                     const std::string &end);

/// Lines that are too wide for the console, or hold escape codes.
std::string bad_lines(const std::string &text);

/// What is not as fem/pipeline/result/summary.schema.json says in a summary, one sentence each.
std::vector<std::string> departures_from_schema(const nlohmann::json &summary);

/// The summary of a folder of results; a departure from the schema fails the test that reads it.
nlohmann::json read_summary(const std::filesystem::path &results);

/// Columns of a table of results by position, as numbers: of CSV or of columns parted by blanks.
std::vector<std::vector<double>> read_columns(const std::filesystem::path &table);

/// Contents of all files below a folder by relative path, without timings.json, which differs from run to
/// run.
std::map<std::string, std::string> all_files(const std::filesystem::path &folder);

/// Names of everything in a folder, hidden files too, without .stemware and the runner's own .out
/// and .err.
std::vector<std::string> names_in(const std::filesystem::path &folder);

/// A study that runs in a second: a step profile that friction does not deform and that does not tilt, the
/// load of rest at every spin. @p further lines are appended.
std::string plain_study(const std::string &further = "");

/// The plain study of a solid body, on a mesh so coarse that it runs in a fraction of a second.
std::string coarse_study(const std::string &further = "");

} // namespace stemware::test
