#include "fem/pipeline/support/results_folder.h"

#include "fem/pipeline/support/failures.h"
#include "fem/pipeline/support/interruption.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <set>
#include <unistd.h>

namespace stemware::pipeline
{

namespace fs = std::filesystem;

namespace
{

/// Absolute path without dots, trailing slash and links, so that its parent and name are clear.
fs::path resolved(const fs::path &path)
{
  std::error_code error;
  fs::path result = fs::weakly_canonical(fs::absolute(path, error), error);
  if (error)
    result = fs::absolute(path).lexically_normal();
  return result.has_filename() ? result : result.parent_path();
}

std::vector<std::string> names_in(const fs::path &folder)
{
  std::vector<std::string> names;
  for (const auto &item : fs::directory_iterator(folder))
    names.push_back(item.path().filename());
  std::sort(names.begin(), names.end());
  return names;
}

/// The files that the summary.json of a results folder lists; nothing where there is no such summary.
std::set<std::string> listed_files(const fs::path &folder)
{
  std::ifstream stream(folder / "summary.json");
  const auto summary = nlohmann::json::parse(stream, nullptr, false);
  std::set<std::string> files;
  if (summary.is_object() && summary.contains("schema") && summary.contains("files") &&
      summary["files"].is_array())
    for (const auto &file : summary["files"])
      if (file.is_string())
        files.insert(file.get<std::string>());
  return files;
}

/// Nothing of anybody else's may be replaced by results.
void require_replaceable(const fs::path &target)
{
  if (!fs::exists(fs::symlink_status(target)))
    return;
  if (!fs::is_directory(target))
    throw OutputFailure("The output " + target.string() +
                        " exists and is not a folder; choose another one with --output.");
  const std::set<std::string> files = listed_files(target);
  for (const std::string &name : names_in(target))
    if (files.count(name) == 0)
      throw OutputFailure(
        "The output folder " + target.string() + " holds " + name +
        ", which is not a result of Stemware; move it away, or choose another folder with --output.");
}

[[noreturn]] void fail_to_write(const fs::path &path, const std::error_code &error)
{
  throw OutputFailure("The results cannot be written to " + path.string() + " (" + error.message() +
                      "); choose another folder with --output.");
}

/// Creates the missing folders of a path, and says which those were, innermost first.
std::vector<fs::path> create_folders(const fs::path &folder)
{
  std::vector<fs::path> missing;
  std::error_code error;
  for (fs::path path = folder; !path.empty() && !fs::exists(path, error); path = path.parent_path())
    missing.push_back(path);
  if (fs::create_directories(folder, error); error)
    fail_to_write(folder, error);
  return missing;
}

/// Deletes a folder into which another thread may still be writing: out of its reach first, then again if a
/// file came in between.
void remove_folder(const fs::path &folder) noexcept
{
  std::error_code error;
  fs::path away = folder;
  away += ".removed";
  fs::rename(folder, away, error);
  for (unsigned int attempt = 0; attempt < 10 && fs::exists(away, error); ++attempt)
    fs::remove_all(away, error);
}

bool begins_with(const std::string &text, const std::string &start)
{
  return text.compare(0, start.size(), start) == 0;
}

/// Removes what killed processes have left of their work on @p target. The older results that a process was
/// about to replace stay where they are the only ones.
void remove_leftovers(const fs::path &target, const std::string &prefix)
{
  for (const std::string &name : names_in(target.parent_path()))
  {
    const fs::path folder = target.parent_path() / name;
    const bool only_copy = folder.extension() == ".replaced" && !fs::exists(target);
    if (begins_with(name, prefix) && !only_copy && FolderClaim(folder).held())
      remove_folder(folder);
  }
}

/// Creates a folder and claims it. Another process may have taken the bare folder for a leftover; then there
/// is a next time.
FolderClaim create_claimed(const fs::path &folder, std::error_code &error)
{
  FolderClaim claim;
  for (unsigned int attempt = 0; attempt < 5 && !claim.held(); ++attempt)
  {
    if (fs::create_directory(folder, error); error)
      break;
    claim = FolderClaim(folder);
  }
  return claim;
}

} // namespace

ResultsFolder::ResultsFolder(const fs::path &wanted)
    : target(resolved(wanted))
{
  try
  {
    require_replaceable(target);
    const auto lock = postpone_interruption();
    created_parents = create_folders(target.parent_path());
    const std::string prefix = "." + target.filename().string() + ".partial-";
    partial = target.parent_path() / (prefix + std::to_string(::getpid()));
    clean_up_on_interruption([this] { remove_partial(); });
    remove_leftovers(target, prefix);
    std::error_code error;
    claim = create_claimed(partial, error);
    if (error)
    {
      remove_partial();
      clean_up_on_interruption({});
      fail_to_write(target, error);
    }
  }
  catch (const fs::filesystem_error &error)
  {
    fail_to_write(target, error.code());
  }
}

ResultsFolder::~ResultsFolder()
{
  const auto lock = postpone_interruption();
  clean_up_on_interruption({});
  if (!published)
    remove_partial();
}

void ResultsFolder::remove_partial() noexcept
{
  remove_folder(partial);
  std::error_code error;
  for (const fs::path &folder : created_parents)
    if (!fs::remove(folder, error)) // fails where something else has come in meanwhile
      break;
}

std::vector<std::string> ResultsFolder::contents() const
{
  return names_in(partial);
}

void ResultsFolder::publish()
{
  const auto lock = postpone_interruption();
  fs::path replaced = partial;
  replaced += ".replaced";
  try
  {
    require_replaceable(target);
    const bool replaces = fs::exists(target);
    if (replaces)
      fs::rename(target, replaced);
    std::error_code error;
    fs::rename(partial, target, error);
    if (error)
    {
      if (replaces)
        fs::rename(replaced, target);
      fail_to_write(target, error);
    }
    published = true;
    clean_up_on_interruption({});
    fs::remove_all(replaced, error);
  }
  catch (const fs::filesystem_error &error)
  {
    fail_to_write(target, error.code());
  }
}

} // namespace stemware::pipeline
