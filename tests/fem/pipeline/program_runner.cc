#include "tests/fem/pipeline/program_runner.h"

#include "fem/pipeline/result/verb_results.h"
#include "tests/fem/pipeline/csv_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <fstream>
#include <memory>
#include <numeric>
#include <set>
#include <spawn.h>
#include <sstream>
#include <stdexcept>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

extern char **environ;

namespace stemware::test
{

namespace fs = std::filesystem;

namespace
{

/// Starts @p command in @p folder, with the files .out and .err as standard output and error. Returns the
/// process id.
pid_t start(const std::vector<std::string> &command, const fs::path &folder)
{
  std::vector<char *> arguments;
  for (const std::string &word : command)
    arguments.push_back(const_cast<char *>(word.c_str()));
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, ".out", O_WRONLY | O_CREAT | O_TRUNC, 0600);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, ".err", O_WRONLY | O_CREAT | O_TRUNC, 0600);
  pid_t process = -1;
  const int error =
    posix_spawnp(&process, command.front().c_str(), &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0)
    throw std::runtime_error("cannot start " + command.front());
  return process;
}

/// Waits for the child process and returns the status of waitpid(). Kills the process after five minutes.
int status_of(pid_t process)
{
  int status = 0;
  for (unsigned int i = 0; ::waitpid(process, &status, WNOHANG) == 0; ++i)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    if (i == 60000)
      ::kill(process, SIGKILL);
  }
  return status;
}

Ended ended_with(int status, const fs::path &folder)
{
  Ended ended;
  ended.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  ended.out = read_text(folder / ".out");
  ended.err = read_text(folder / ".err");
  return ended;
}

void set_environment()
{
  for (const char *name : { "OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS" })
    ::setenv(name, "1", 1);
  ::setenv("UCX_DEBUG_SIGNO", "0", 0); // UCX, which Open MPI 5 loads, would catch SIGHUP
}

} // namespace

RunningProgram::RunningProgram(const std::vector<std::string> &command, const fs::path &folder)
    : folder(folder)
{
  set_environment();
  process = start(command, folder);
}

bool RunningProgram::wait_for_output(const std::string &text) const
{
  for (;;)
  {
    if (read_text(folder / ".out").find(text) != std::string::npos)
      return true;
    siginfo_t info = {};
    if (::waitid(P_PID, static_cast<id_t>(process), &info, WEXITED | WNOHANG | WNOWAIT) != 0 ||
        info.si_pid != 0)
      return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
}

void RunningProgram::send(int signal) const
{
  ::kill(process, signal);
}

Ended RunningProgram::end()
{
  return ended_with(status_of(process), folder);
}

Ended stemware(const ScratchFolder &scratch, const std::vector<std::string> &arguments)
{
  std::vector<std::string> command = { STEMWARE_PROGRAM };
  command.insert(command.end(), arguments.begin(), arguments.end());
  return RunningProgram(command, scratch.path()).end();
}

std::vector<std::string> with_settings(std::vector<std::string> command,
                                       const std::vector<std::string> &settings)
{
  for (const std::string &setting : settings)
    command.insert(command.end(), { "--set", setting });
  return command;
}

nlohmann::json solved(const ScratchFolder &scratch, const std::vector<std::string> &command,
                      const std::vector<std::string> &settings, const std::string &results)
{
  std::vector<std::string> whole = with_settings(command, settings);
  whole.insert(whole.end(), { "--output", results });
  const Ended ended = stemware(scratch, whole);
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  return ended.exit_code == 0 ? read_summary(scratch / results) : nlohmann::json();
}

std::string read_text(const fs::path &file)
{
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

std::string bad_lines(const std::string &text)
{
  std::string bad;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
  {
    const auto n_columns =
      std::count_if(line.begin(), line.end(), [](char letter) { return (letter & 0xC0) != 0x80; });
    if (n_columns > 100 || line.find('\x1b') != std::string::npos)
      bad += line + '\n';
  }
  return bad;
}

std::vector<std::string> departures_from_schema(const nlohmann::json &summary)
{
  using valijson::adapters::NlohmannJsonAdapter;
  static const nlohmann::json text = nlohmann::json::parse(pipeline::summary_schema());
  static const auto schema = []
  {
    auto parsed = std::make_unique<valijson::Schema>();
    valijson::SchemaParser().populateSchema(NlohmannJsonAdapter(text), *parsed);
    return parsed;
  }();
  valijson::ValidationResults found;
  valijson::Validator().validate(*schema, NlohmannJsonAdapter(summary), &found);
  std::vector<std::string> departures;
  for (valijson::ValidationResults::Error error; found.popError(error);)
    departures.push_back(std::accumulate(error.context.begin(), error.context.end(), std::string()) + ": " +
                         error.description);
  return departures;
}

nlohmann::json read_summary(const fs::path &results)
{
  const nlohmann::json summary = nlohmann::json::parse(read_text(results / "summary.json"));
  for (const std::string &trouble : departures_from_schema(summary))
    ADD_FAILURE() << "summary.json in " << results << ": " << trouble;
  return summary;
}

/// Returns the columns of a CSV text with one header line. Empty fields are NaN.
std::vector<std::vector<double>> csv_columns(const std::string &text)
{
  const auto rows = parse_csv(text);
  std::vector<std::vector<double>> columns(rows.at(0).size());
  for (std::size_t r = 1; r < rows.size(); ++r)
    for (std::size_t c = 0; c < columns.size(); ++c)
      columns[c].push_back(rows[r].at(c).empty() ? std::nan("") : std::stod(rows[r][c]));
  return columns;
}

std::vector<std::vector<double>> read_columns(const fs::path &table)
{
  if (table.extension() == ".csv")
    return csv_columns(read_text(table));
  std::vector<std::vector<double>> columns;
  std::istringstream lines(read_text(table));
  for (std::string line; std::getline(lines, line);)
  {
    if (line.empty() || line[0] == '#')
      continue;
    std::istringstream words(line);
    std::string word;
    for (std::size_t c = 0; words >> word; ++c)
    {
      if (columns.size() <= c)
        columns.resize(c + 1);
      columns[c].push_back(std::stod(word));
    }
  }
  return columns;
}

std::map<std::string, std::string> all_files(const fs::path &folder)
{
  std::map<std::string, std::string> files;
  for (const auto &item : fs::recursive_directory_iterator(folder))
    if (item.is_regular_file() && item.path().filename() != "timings.json")
      files[fs::relative(item.path(), folder).string()] = read_text(item.path());
  return files;
}

std::vector<std::string> names_in(const fs::path &folder)
{
  std::vector<std::string> names;
  for (const auto &item : fs::directory_iterator(folder))
    if (const std::set<std::string> own = { ".out", ".err", ".stemware" };
        own.count(item.path().filename()) == 0)
      names.push_back(item.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

std::string between(const std::string &text, const std::string &begin, const std::string &end)
{
  const auto from = text.find(begin);
  if (from == std::string::npos)
    return "";
  return text.substr(from + begin.size(), text.find(end, from + begin.size()) - from - begin.size());
}

std::vector<std::string> all_between(const std::string &text, const std::string &begin,
                                     const std::string &end)
{
  std::vector<std::string> found;
  for (auto at = text.find(begin); at != std::string::npos; at = text.find(begin, at + 1))
    found.push_back(between(text.substr(at), begin, end));
  return found;
}

std::string plain_study(const std::string &further)
{
  return "subsection Motion\n  set Tilt = neglected\nend\n"
         "subsection Table\n  set Interface = Winkler\n  set Substrate = rigid\nend\n"
         "subsection Glass\n  set Shape = step\nend\n"
         "subsection Contact\n  set Friction coupling = none\nend\n"
         "subsection Load\n  set Coupling = one-way\nend\n" +
         further;
}

std::string coarse_study(const std::string &further)
{
  return plain_study("subsection Contact\n  set Body = solid\n  set Degree = 1\n  set Azimuthal cells = 16\n"
                     "  set Radial cells = 2\n  set Foot layers = 1\nend\n" +
                     further);
}

} // namespace stemware::test
