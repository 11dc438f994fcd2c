#include "fem/pipeline/analysis/sweep/sweep_folder.h"

#include "fem/pipeline/support/failures.h"
#include "fem/pipeline/support/json_text.h"
#include "fem/pipeline/support/text_file.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <fstream>
#include <regex>
#include <set>
#include <unistd.h>

namespace stemware::pipeline
{

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace
{

/// In the line of a case that was solved, and in no other: quotes within a message have a backslash before
/// them.
constexpr char no_message[] = "\"message\":\"\",";

[[noreturn]] void fail_to_keep(const fs::path &file)
{
  throw OutputFailure(fmt::format(
    FMT_STRING(
      "The finished cases cannot be kept in {} ({}); make room, or choose another folder with --output."),
    file.string(), std::strerror(errno)));
}

std::string line_of(std::size_t index, const CaseResult &result)
{
  Json line = { { "case", index }, { "outcome", result.outcome }, { "message", result.message } };
  Json &values = line["values"] = Json::array();
  for (const std::optional<double> &value : result.values)
    values.push_back(value ? Json(*value) : Json(nullptr));
  return line.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n';
}

/// The case of a line, or nothing where it is not whole.
std::optional<std::pair<std::size_t, CaseResult>> case_of(const std::string &line)
{
  try
  {
    const Json json = json_in(line).value_or(Json());
    CaseResult result;
    result.outcome = json.at("outcome").get<std::string>();
    result.message = json.at("message").get<std::string>();
    for (const Json &value : json.at("values"))
      result.values.push_back(value.is_null() ? std::nullopt : std::optional(value.get<double>()));
    if (result.values.size() != (result.is_solved() ? sweep_quantities().size() : 0))
      return std::nullopt;
    return std::pair(json.at("case").get<std::size_t>(), result);
  }
  catch (const Json::exception &)
  {
    return std::nullopt;
  }
}

constexpr char plan_name[] = "plan.json";

/// First key of the plan: the folder is one of ours.
constexpr char what_it_is[] = "finished cases of stemware sweep";

fs::path folder_beside(const fs::path &results)
{
  return results.parent_path() / ("." + results.filename().string() + ".sweep");
}

bool is_log_name(const std::string &name)
{
  static const std::regex pattern("cases-(0|[1-9][0-9]*)[.]jsonl"); // SweepFolder::log_of()
  return std::regex_match(name, pattern);
}

/// Whether a plan has that name while it is written: it stays where the program is killed meanwhile.
bool is_left_over(const std::string &name)
{
  return name.rfind(std::string(".") + plan_name + ".partial-", 0) == 0;
}

/// The logs that are in the folder; none where it is gone.
std::set<fs::path> logs_that_are_in(const fs::path &folder)
{
  std::set<fs::path> logs;
  std::error_code error;
  for (const auto &item : fs::directory_iterator(folder, error))
    if (is_log_name(item.path().filename()) && is_plain_file(item.path()))
      logs.insert(item.path());
  return logs;
}

/// Whole or not at all, even if the power fails.
void write_durably(const fs::path &file, const std::string &text)
{
  write_text_file(file, text);
  const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  ::fsync(descriptor);
  ::close(descriptor);
}

/// How the sweep that is kept differs from the one that is asked for.
std::string difference(const Json &kept, const Json &asked)
{
  if (kept.value("program", Json()) != asked.at("program"))
    return "a sweep of another version of the program";
  if (kept.value("files", Json()) != asked.at("files"))
    return "a sweep whose mesh or load file has changed since";
  return "another sweep";
}

} // namespace

CaseLog::CaseLog(const fs::path &file)
    : file(file)
    , descriptor(::open(file.c_str(), O_WRONLY | O_APPEND | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0666))
    , last_sync(std::chrono::steady_clock::now())
{
  if (descriptor < 0)
    fail_to_keep(file);
}

CaseLog::~CaseLog()
{
  ::fdatasync(descriptor);
  ::close(descriptor);
}

void CaseLog::append(std::size_t index, const CaseResult &result)
{
  const std::string line = line_of(index, result);
  if (::write(descriptor, line.data(), line.size()) != static_cast<ssize_t>(line.size()))
    fail_to_keep(file);
  const auto now = std::chrono::steady_clock::now();
  if (now - last_sync < std::chrono::seconds(1))
    return;
  last_sync = now;
  if (::fdatasync(descriptor) != 0 && errno != EINVAL && errno != EROFS) // some file systems cannot be asked
    fail_to_keep(file);
}

FinishedCases recover_cases(const fs::path &log)
{
  FinishedCases cases;
  std::error_code error;
  const std::string text = read_text_file(log);
  std::size_t n_good = 0;
  for (std::size_t end; (end = text.find('\n', n_good)) != std::string::npos; n_good = end + 1)
  {
    const auto finished = case_of(text.substr(n_good, end - n_good));
    if (!finished)
      break;
    cases.insert(*finished);
  }
  const bool is_all = text.size() == fs::file_size(log, error); // else it could not be read
  if (is_all && n_good < text.size() && ::truncate(log.c_str(), static_cast<off_t>(n_good)) != 0)
    fail_to_keep(log);
  return cases;
}

FinishedCases finished_cases(const fs::path &folder)
{
  FinishedCases all;
  for (const fs::path &log : logs_that_are_in(folder))
    all.merge(recover_cases(log));
  return all;
}

const CaseCount &LogCounter::count()
{
  for (const fs::path &log : logs_that_are_in(folder))
  {
    std::uintmax_t &n_read = n_bytes[log];
    std::ifstream stream(log, std::ios::binary);
    stream.seekg(static_cast<std::streamoff>(n_read));
    for (std::string line; std::getline(stream, line) && !stream.eof();) // the last line has its end already
    {
      n_read += line.size() + 1;
      ++cases.n_finished;
      cases.n_failed += line.find(no_message) == std::string::npos ? 1 : 0;
    }
  }
  return cases;
}

SweepFolder::SweepFolder(const fs::path &results_wanted, const Json &identity, bool restart)
    : results(resolved(results_wanted))
    , folder(folder_beside(results))
{
  try
  {
    take();
    require_own();
    adopt(identity, restart);
  }
  catch (const std::runtime_error &failure)
  {
    remove_empty_folders(created);
    if (const auto *error = dynamic_cast<const fs::filesystem_error *>(&failure))
      throw OutputFailure(fmt::format(
        FMT_STRING("The finished cases cannot be kept in {} ({}); choose another folder with --output."),
        folder.string(), error->code().message()));
    throw;
  }
}

SweepFolder::~SweepFolder()
{
  remove_if_empty();
}

void SweepFolder::take()
{
  if (fs::exists(fs::symlink_status(folder)) && !is_plain_folder(folder))
    throw OutputFailure(
      fmt::format(FMT_STRING("{}, where a sweep keeps its finished cases, is not a folder of its own but a "
                             "link or a file; move it away, or choose another folder with --output."),
                  folder.string()));
  created = create_folders(folder);
  claim = FolderClaim(folder); // not of a link that has come in between
  if (!claim.held())
    throw OutputFailure(fmt::format(FMT_STRING("Another sweep is computing into {}; wait until it has ended, "
                                               "or choose another folder with --output."),
                                    results.string()));
}

void SweepFolder::require_own() const
{
  const Json plan =
    json_in(is_plain_file(folder / plan_name) ? read_text_file(folder / plan_name) : "").value_or(Json());
  const bool has_plan = plan.is_object() && plan.value("what", Json()) == what_it_is;
  for (const std::string &name : names_in(folder))
    if (!is_plain_file(folder / name) ||
        !(is_left_over(name) || (has_plan && (name == plan_name || is_log_name(name)))))
      throw OutputFailure(
        fmt::format(FMT_STRING("The folder {}, where a sweep keeps its finished cases, holds {}, which is "
                               "not one of its files; move it away, or choose another folder with --output."),
                    folder.string(), name));
}

void SweepFolder::adopt(const Json &identity, bool restart)
{
  for (const std::string &name : names_in(folder))
    if (is_left_over(name))
      fs::remove(folder / name);
  const fs::path plan = folder / plan_name;
  Json marked = { { "what", what_it_is } };
  marked.update(identity);
  const std::string wanted = marked.dump(1) + "\n";
  const std::string kept = read_text_file(plan);
  if (!restart && kept == wanted)
    return;
  const std::size_t n_finished = restart ? 0 : finished_cases(folder).size();
  if (n_finished > 0)
    throw OutputFailure(fmt::format(FMT_STRING("The folder {} keeps {} finished cases of {}; choose another "
                                               "folder with --output, or add --restart to throw them away."),
                                    folder.string(), n_finished,
                                    difference(json_in(kept).value_or(Json::object()), identity)));
  for (const fs::path &log : logs_that_are_in(folder))
    fs::remove(log);
  write_durably(plan, wanted);
}

fs::path SweepFolder::log_of(const fs::path &path, unsigned int rank)
{
  return path / fmt::format(FMT_STRING("cases-{}.jsonl"), rank);
}

void SweepFolder::remove() noexcept
{
  // The plan last: what is left of a folder when the program is killed here is still one of a sweep.
  std::error_code error;
  for (const fs::path &log : logs_that_are_in(folder))
    fs::remove(log, error);
  if (is_plain_file(folder / plan_name))
    fs::remove(folder / plan_name, error);
  ::rmdir(folder.c_str());
}

void SweepFolder::remove_if_empty() noexcept
{
  std::error_code error;
  for (const fs::path &log : logs_that_are_in(folder))
    if (fs::file_size(log, error) > 0)
      return;
  remove();
  remove_empty_folders(created);
}

} // namespace stemware::pipeline
