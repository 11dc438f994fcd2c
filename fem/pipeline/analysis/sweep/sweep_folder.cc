#include "fem/pipeline/analysis/sweep/sweep_folder.h"

#include "fem/pipeline/support/failures.h"
#include "fem/pipeline/support/text_file.h"

#include <fcntl.h>
#include <fstream>
#include <set>
#include <sstream>
#include <unistd.h>

namespace stemware::pipeline
{

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace
{

/// Absolute path without dots and trailing slash.
fs::path resolved(const fs::path &path)
{
  const fs::path result = fs::weakly_canonical(fs::absolute(path));
  return result.has_filename() ? result : result.parent_path();
}

fs::path folder_beside(const fs::path &results)
{
  return results.parent_path() / ("." + results.filename().string() + ".sweep");
}

std::string content_of(const fs::path &file)
{
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

/// Whole or not at all, even if the power fails.
void write_durably(const fs::path &file, const std::string &text)
{
  fs::path partial = file;
  partial += ".partial";
  write_text_file(partial, text);
  const int descriptor = ::open(partial.c_str(), O_RDONLY | O_CLOEXEC);
  ::fsync(descriptor);
  ::close(descriptor);
  fs::rename(partial, file);
}

/// How the sweep that is kept differs from the one that is asked for.
std::string difference(const Json &kept, const Json &asked)
{
  if (!kept.is_object())
    return "a sweep whose plan cannot be read";
  if (kept.value("program", Json()) != asked.at("program"))
    return "a sweep of another version of the program";
  if (kept.value("files", Json()) != asked.at("files"))
    return "a sweep whose mesh or load file has changed since";
  return "another sweep";
}

} // namespace

SweepFolder::SweepFolder(const fs::path &results_wanted, const Json &identity, bool restart)
    : results(resolved(results_wanted))
    , folder(folder_beside(results))
{
  try
  {
    take();
    adopt(identity, restart);
  }
  catch (const fs::filesystem_error &error)
  {
    throw OutputFailure("The finished cases cannot be kept in " + folder.string() + " (" +
                        error.code().message() + "); choose another folder with --output.");
  }
}

SweepFolder::~SweepFolder()
{
  remove_if_empty();
}

void SweepFolder::take()
{
  for (fs::path path = folder.parent_path(); !path.empty() && !fs::exists(path); path = path.parent_path())
    created_parents.push_back(path);
  // Another sweep may end and remove the folder between the two steps; then there is a next time.
  for (unsigned int attempt = 0; attempt < 5 && !claim.held(); ++attempt)
  {
    fs::create_directories(folder);
    claim = FolderClaim(folder);
  }
  if (!claim.held())
    throw OutputFailure("Another sweep is computing into " + results.string() +
                        "; wait until it has ended, or choose another folder with --output.");
}

void SweepFolder::adopt(const Json &identity, bool restart)
{
  const fs::path plan = folder / "plan.json";
  const std::string wanted = identity.dump(1) + "\n";
  if (!restart && content_of(plan) == wanted)
    return;
  const std::size_t n_finished = restart ? 0 : finished_cases().size();
  if (n_finished > 0)
    throw OutputFailure("The folder " + folder.string() + " keeps " + std::to_string(n_finished) +
                        " finished cases of " +
                        difference(Json::parse(content_of(plan), nullptr, false), identity) +
                        "; choose another folder with --output, or add --restart to throw them away.");
  for (const auto &item : fs::directory_iterator(folder))
    fs::remove_all(item.path());
  write_durably(plan, wanted);
}

fs::path SweepFolder::log_of(const fs::path &path, unsigned int rank)
{
  return path / ("cases-" + std::to_string(rank) + ".jsonl");
}

FinishedCases SweepFolder::finished_cases() const
{
  FinishedCases all;
  for (const auto &item : fs::directory_iterator(folder))
    if (item.path().extension() == ".jsonl")
      all.merge(recover_cases(item.path()));
  return all;
}

std::vector<LogCounter> SweepFolder::logs_in(const fs::path &path, unsigned int n_ranks)
{
  std::set<fs::path> files;
  std::error_code error; // the folder may be gone
  for (const auto &item : fs::directory_iterator(path, error))
    if (item.path().extension() == ".jsonl")
      files.insert(item.path());
  for (unsigned int rank = 0; rank < n_ranks; ++rank)
    files.insert(log_of(path, rank));
  return std::vector<LogCounter>(files.begin(), files.end());
}

CaseCount SweepFolder::count(std::vector<LogCounter> &logs)
{
  CaseCount total;
  for (LogCounter &log : logs)
  {
    const CaseCount &cases = log.count();
    total.n_finished += cases.n_finished;
    total.n_failed += cases.n_failed;
  }
  return total;
}

void SweepFolder::remove() noexcept
{
  // Out of the way first, so that a sweep that starts meanwhile has a folder of its own.
  std::error_code error;
  fs::path away = folder;
  away += ".removed-" + std::to_string(::getpid());
  fs::rename(folder, away, error);
  fs::remove_all(away, error);
}

void SweepFolder::remove_if_empty() noexcept
{
  std::error_code error;
  for (const auto &item : fs::directory_iterator(folder, error))
    if (item.path().extension() == ".jsonl" && item.file_size(error) > 0)
      return;
  remove();
  for (const fs::path &parent : created_parents)
    if (!fs::remove(parent, error)) // fails where something else has come in meanwhile
      break;
}

} // namespace stemware::pipeline
