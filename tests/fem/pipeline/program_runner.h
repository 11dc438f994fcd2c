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

struct Ended
{
  int exit_code = -1; ///< 128 + signal number if a signal killed the program
  std::string out;
  std::string err;
};

/// Running program, whose standard output and error are the files .out and .err in its folder.
class RunningProgram
{
public:
  RunningProgram(const std::vector<std::string> &command, const std::filesystem::path &folder);

  /// Waits until standard output contains @p text. Returns false if the program ends before.
  bool wait_for_output(const std::string &text) const;

  void send(int signal) const;

  /// Waits for the end of the program and returns its exit code and output; to be called once. Kills the
  /// program after five minutes.
  Ended end();

private:
  std::filesystem::path folder;
  pid_t process = -1;
};

Ended stemware(const ScratchFolder &scratch, const std::vector<std::string> &arguments);

std::vector<std::string> with_settings(std::vector<std::string> command,
                                       const std::vector<std::string> &settings);

/// Runs @p command with @p settings, expects success, and returns the summary in the folder @p results.
nlohmann::json solved(const ScratchFolder &scratch, const std::vector<std::string> &command,
                      const std::vector<std::string> &settings = {}, const std::string &results = "results");

std::string read_text(const std::filesystem::path &file);

/// Returns the text between @p begin and the next @p end in @p text; empty if @p begin is missing.
std::string between(const std::string &text, const std::string &begin, const std::string &end);

std::vector<std::string> all_between(const std::string &text, const std::string &begin,
                                     const std::string &end);

/// Returns lines that are too wide for the console or contain escape codes.
std::string bad_lines(const std::string &text);

/// Returns the violations of summary_schema() in a summary, one sentence each.
std::vector<std::string> departures_from_schema(const nlohmann::json &summary);

/// Returns the summary in @p results. Expects that it satisfies summary_schema().
nlohmann::json read_summary(const std::filesystem::path &results);

/// Returns the columns of a CSV file, or of a table with columns separated by blanks.
std::vector<std::vector<double>> read_columns(const std::filesystem::path &table);

/// Returns the contents of all files below @p folder by relative path, without timings.json, which differs
/// between runs.
std::map<std::string, std::string> all_files(const std::filesystem::path &folder);

/// Returns the sorted names in a folder, including hidden files, without .stemware, .out and .err.
std::vector<std::string> names_in(const std::filesystem::path &folder);

/// Returns a study that runs in a second: step profile, no friction coupling, no tilt, load at rest for every
/// spin. Appends the lines @p further.
std::string plain_study(const std::string &further = "");

std::string coarse_study(const std::string &further = "");

} // namespace stemware::test
