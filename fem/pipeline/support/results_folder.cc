#include "fem/pipeline/support/results_folder.h"

#include "fem/pipeline/support/console.h"
#include "fem/pipeline/support/failures.h"
#include "fem/pipeline/support/interruption.h"
#include "fem/pipeline/support/json_text.h"
#include "fem/pipeline/support/ranks.h"
#include "fem/pipeline/support/text.h"
#include "fem/pipeline/support/text_file.h"

#include <fmt/format.h>
#include <map>
#include <ostream>

namespace stemware::pipeline
{

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

const char *const manifest_name = "manifest.json";

namespace
{

/// How the manifest describes a file with that content.
Json description_of(const std::string &content)
{
  if (is_sealed(content))
    return { { "sealed", true } };
  return { { "bytes", content.size() }, { "crc64", check_sum(content) } };
}

/// Content of a folder of results, by relative path: files by their description, folders as "folder", all
/// else as null.
using Content = std::map<std::string, Json>;

Content content_of(const fs::path &folder)
{
  Content content;
  for (const auto &item : fs::recursive_directory_iterator(folder)) // follows no links
    content[item.path().lexically_relative(folder)] = is_plain_folder(item) ? Json("folder")
                                                      : is_plain_file(item)
                                                        ? description_of(read_text_file(item))
                                                        : Json();
  return content;
}

/// Content of @p folder by its manifest: the files listed, their folders, and the manifest itself; nothing
/// where there is no manifest of ours.
Content listed_in(const fs::path &folder)
{
  const fs::path file = folder / manifest_name;
  const std::string text = is_plain_file(file) ? read_text_file(file) : "";
  const Json manifest = json_in(text).value_or(Json());
  if (!manifest.is_object() || manifest.value("program", Json()) != "stemware" ||
      !manifest.value("files", Json()).is_object())
    return {};
  Content listed = { { manifest_name, description_of(text) } };
  for (const auto &[name, description] : manifest.at("files").items())
  {
    listed[name] = description;
    for (auto slash = name.find('/'); slash != std::string::npos; slash = name.find('/', slash + 1))
      listed[name.substr(0, slash)] = "folder";
  }
  return listed;
}

[[noreturn]] void fail_to_write(const fs::path &path, const std::error_code &error)
{
  throw OutputFailure(
    fmt::format(FMT_STRING("The results cannot be written to {} ({}); choose another folder with --output."),
                path.string(), error.message()));
}

/// Removes a file, or a folder and what is in it. Unlike fs::remove_all() with one open descriptor at a time:
/// others may be what has run out.
void remove_tree(const fs::path &path)
{
  std::error_code ignored;
  if (is_plain_folder(path))
    for (const std::string &name : names_in(path))
      remove_tree(path / name);
  fs::remove(path, ignored);
}

/// Deletes a folder that this process has made, and into which another of its threads may still be writing:
/// out of its reach first, then again if a file came in between.
void remove_own_folder(const fs::path &folder) noexcept
{
  std::error_code error;
  fs::path away = folder;
  away += ".removed";
  fs::rename(folder, away, error);
  for (unsigned int attempt = 0; attempt < 10 && fs::exists(away, error); ++attempt)
    try
    {
      remove_tree(away);
    }
    catch (const fs::filesystem_error &)
    {
      // What cannot be looked at stays.
    }
}

/// Removes a folder that holds nothing but what its manifest lists; false for every other one.
bool remove_results(const fs::path &folder) noexcept
try
{
  if (why_not_replaceable(folder))
    return false;
  remove_tree(folder);
  return true;
}
catch (const std::exception &)
{
  return false;
}

/// Removes what killed processes have left of their work on @p target, where it is theirs beyond doubt: a
/// folder that nobody works in, and that holds nothing but what its manifest lists. What may be a user's is
/// named and left. The older results that a process was about to replace stay where they are the only ones.
void remove_leftovers(const fs::path &target, const std::string &prefix)
{
  for (const std::string &name : names_in(target.parent_path()))
  {
    const fs::path folder = target.parent_path() / name;
    const bool only_copy = folder.extension() == ".replaced" && !fs::exists(target);
    if (name.rfind(prefix, 0) == 0 && !only_copy && is_plain_file(folder / manifest_name) &&
        FolderClaim(folder).held() && !remove_results(folder))
      console() << wrapped(fmt::format(FMT_STRING("{} is left of a run that was killed, and may hold files "
                                                  "of yours; delete it if you do not need it."),
                                       folder.string()),
                           "Remark    ")
                << std::endl;
  }
}

} // namespace

void write_manifest(const fs::path &folder)
{
  Json files = Json::object();
  for (const auto &[name, description] : content_of(folder))
    if (name != manifest_name && description.is_object())
      files[name] = description;
  const Json manifest = { { "program", "stemware" }, { "files", files } };
  replace_text_file(folder / manifest_name, manifest.dump(2) + "\n");
}

std::optional<std::string> why_not_replaceable(const fs::path &folder)
{
  const Content listed = listed_in(folder);
  for (const auto &[name, description] : content_of(folder))
    if (const auto found = listed.find(name); found == listed.end())
      return "holds " + name + ", which is not a result of Stemware";
    else if (found->second != description)
      return "holds " + name + ", which has changed since Stemware wrote it";
  return std::nullopt;
}

void require_replaceable(const fs::path &wanted)
{
  const fs::path target = resolved(wanted);
  if (!fs::exists(fs::symlink_status(target)))
    return;
  if (!is_plain_folder(target))
    throw OutputFailure("The output " + target.string() +
                        " exists and is not a folder; choose another one with --output.");
  if (const auto reason = why_not_replaceable(target))
    throw OutputFailure(fmt::format(
      FMT_STRING("The output folder {} {}; move it away, or choose another folder with --output."),
      target.string(), *reason));
}

ResultsFolder::ResultsFolder(const fs::path &wanted)
    : target(resolved(wanted))
{
  const auto claimed = [this]
  {
    claim_place();
    return partial.string();
  };
  partial = from_first_rank(claimed);
}

void ResultsFolder::claim_place()
try
{
  const std::string prefix = "." + target.filename().string() + ".partial-";
  const PostponedInterruption postponed;
  try
  {
    require_replaceable(target);
    created_parents = create_folders(target.parent_path());
    remove_leftovers(target, prefix);
    const fs::path made = target.parent_path() / (prefix + unique_suffix());
    create_new_folder(made);
    partial = made;
    claim = FolderClaim(partial);
    write_manifest(partial); // a killed process leaves nothing that the next one has to take for a user's
    postponed->clean_up = [this] { remove_partial(); };
  }
  catch (...)
  {
    remove_partial();
    throw;
  }
}
catch (const fs::filesystem_error &error)
{
  fail_to_write(target, error.code());
}

ResultsFolder::~ResultsFolder()
{
  if (!is_first_rank())
    return;
  const PostponedInterruption postponed;
  postponed->clean_up = {};
  if (!published)
    remove_partial();
}

void ResultsFolder::remove_partial() noexcept
{
  claim = FolderClaim(); // and its descriptor is free
  if (!partial.empty())
    remove_own_folder(partial);
  remove_empty_folders(created_parents);
}

void ResultsFolder::publish()
try
{
  const PostponedInterruption postponed;
  fs::path replaced = partial;
  replaced += ".replaced";
  write_manifest(partial);
  require_replaceable(target);
  const bool replaces = fs::exists(target);
  if (replaces)
    fs::rename(target, replaced);
  std::error_code error;
  fs::rename(partial, target, error);
  if (error && replaces)
    fs::rename(replaced, target);
  if (error)
    fail_to_write(target, error);
  published = true;
  postponed->clean_up = {};
  if (replaces)
    remove_results(replaced);
}
catch (const fs::filesystem_error &error)
{
  fail_to_write(target, error.code());
}

} // namespace stemware::pipeline
