#include "fem/pipeline/support/results_folder.h"

#include "fem/pipeline/support/console.h"
#include "fem/pipeline/support/failures.h"
#include "fem/pipeline/support/interruption.h"
#include "fem/pipeline/support/manifest.h"
#include "fem/pipeline/support/ranks.h"
#include "fem/pipeline/support/text.h"

#include <fmt/format.h>
#include <ostream>

namespace stemware::pipeline
{

namespace fs = std::filesystem;

namespace
{

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

/// Removes what killed processes have left of their work on @p target, where it is theirs beyond doubt: a
/// folder that nobody works in, and that holds nothing but what its manifest lists. What may be a user's is
/// named and left. The older results that a process was about to replace stay where they are the only ones.
void remove_leftovers(const fs::path &target, const std::string &prefix)
{
  for (const std::string &name : names_in(target.parent_path()))
  {
    const fs::path folder = target.parent_path() / name;
    const bool only_copy = folder.extension() == ".replaced" && !fs::exists(target);
    if (name.rfind(prefix, 0) != 0 || only_copy || !is_plain_folder(folder) || !FolderClaim(folder).held() ||
        !has_manifest(folder))
      continue;
    if (!why_not_replaceable(folder))
      remove_listed_files(folder);
    else
      console() << wrapped(fmt::format(FMT_STRING("{} is left of a run that was killed, and may hold files "
                                                  "of yours; delete it if you do not need it."),
                                       folder.string()),
                           "Remark    ")
                << std::endl;
  }
}

} // namespace

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
{
  const std::string prefix = "." + target.filename().string() + ".partial-";
  const auto lock = postpone_interruption();
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
    clean_up_on_interruption([this] { remove_partial(); });
  }
  catch (const fs::filesystem_error &error)
  {
    remove_partial();
    fail_to_write(target, error.code());
  }
  catch (...)
  {
    remove_partial();
    throw;
  }
}

ResultsFolder::~ResultsFolder()
{
  if (!is_first_rank())
    return;
  const auto lock = postpone_interruption();
  clean_up_on_interruption({});
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
{
  const auto lock = postpone_interruption();
  fs::path replaced = partial;
  replaced += ".replaced";
  try
  {
    write_manifest(partial);
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
    if (!replaces)
      return;
    remove_listed_files(replaced);
    fs::remove(replaced, error); // an empty folder has no manifest
  }
  catch (const fs::filesystem_error &error)
  {
    fail_to_write(target, error.code());
  }
}

} // namespace stemware::pipeline
