#include "fem/pipeline/analysis/sweep/case_log.h"

#include "fem/pipeline/support/failures.h"
#include "fem/pipeline/support/json_text.h"
#include "fem/pipeline/support/text_file.h"

#include <nlohmann/json.hpp>

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <fstream>
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
  std::ifstream stream(log, std::ios::binary);
  std::uintmax_t n_good = 0;
  bool is_whole = true;
  for (std::string line; is_whole && std::getline(stream, line);)
  {
    const auto finished = stream.eof() ? std::nullopt : case_of(line); // at the end of the file: no line end
    is_whole = finished.has_value();
    if (!is_whole)
      continue;
    cases.insert(*finished);
    n_good += line.size() + 1;
  }
  stream.close();
  std::error_code error;
  if (!is_whole)
    fs::resize_file(log, n_good, error);
  errno = error.value();
  if (error)
    fail_to_keep(log);
  return cases;
}

const CaseCount &LogCounter::count()
{
  for (auto &[log, n_read] : n_bytes)
  {
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

} // namespace stemware::pipeline
