#include "fem/pipeline/base/output.h"

#include "fem/pipeline/base/failures.h"
#include "fem/pipeline/base/ranks.h"
#include "fem/pipeline/base/text_file.h"

#include <fstream>
#include <iterator>
#include <set>
#include <unistd.h>
#include <utility>
#include <vector>

namespace stemware::pipeline
{
namespace fs = std::filesystem;

namespace
{
/// Files in a results folder. `own`: the file `stamp_name` and the files listed in it, contents before
/// folders; `hidden`: hidden and system files; `others`: files of the user.
struct Content
{
  std::vector<std::string> own, hidden;
  std::set<std::string> others;
};

Content content_of(const fs::path &folder)
{
  std::ifstream stream(folder / stamp_name);
  const std::set<std::string> stamp(std::istream_iterator<std::string>(stream), {});
  Content content;
  std::error_code error;
  for (fs::recursive_directory_iterator item(folder, error), end; item != end; ++item)
  {
    const std::string path = item->path().lexically_relative(folder), name = item->path().filename();
    const bool is_fields = path == "fields" && item->symlink_status().type() == fs::file_type::directory;
    if (!is_fields)
      item.disable_recursion_pending();
    if ((is_fields || item->symlink_status().type() == fs::file_type::regular) &&
        (path == stamp_name || stamp.count(path) > 0))
      content.own.insert(content.own.begin(), path);
    else if (name[0] == '.' || name == "Thumbs.db" || name == "desktop.ini")
      content.hidden.push_back(path);
    else
      content.others.insert(path);
  }
  return content;
}

void remove_results(const fs::path &folder)
{
  for (const std::string &name : content_of(folder).own)
    std::remove((folder / name).c_str());
  ::rmdir(folder.c_str());
}

void ensure_output(bool is_good, const fs::path &path, const std::string &trouble)
{
  if (!is_good)
    throw OutputFailure("The output " + shortened_path(path.string()) + trouble + " choose another place.");
}

std::string partial_name(const fs::path &path)
{
  std::string name = path.string() + ".partial-" + std::to_string(::getpid());
  std::error_code error;
  while (fs::exists(fs::symlink_status(name, error)))
    name += '-';
  return name;
}

std::string make_partial_folder(const fs::path &target)
{
  std::error_code error;
  std::string name = partial_name(target);
  fs::create_directories(name, error);
  ensure_output(!error, target, " cannot be written (" + error.message() + ");");
  return name;
}
} // namespace

void require_replaceable(const fs::path &folder)
{
  std::error_code error;
  const fs::file_status status = fs::symlink_status(folder, error);
  ensure_output(!fs::exists(status) || fs::is_directory(status), folder, " is not a folder;");
  const fs::path inside = fs::current_path().lexically_relative(fs::weakly_canonical(folder, error));
  ensure_output(inside.empty() || *inside.begin() == "..", folder,
                " contains the folder where the program was started;");
  for (const std::string &name : content_of(folder).others)
    ensure_output(false, folder,
                  " holds " + shortened(name) + ", which Stemware did not write; move it away or");
}

ResultsFolder::ResultsFolder(const fs::path &wanted)
    : target(fs::absolute(wanted.has_filename() ? wanted : wanted.parent_path()).lexically_normal())
{
  on_first_rank(
    [this]
    {
      require_replaceable(target);
      std::error_code error, no_error;
      made_parent = !fs::exists(target.parent_path(), no_error);
      const std::string probe = make_partial_folder(target);
      if (fs::exists(target, no_error) && fs::is_empty(target, no_error))
        fs::rename(probe, target, error); // fails if the folder is a mount point
      fs::remove_all(probe, no_error);
      ensure_output(!error, target, " cannot be written (" + error.message() + ");");
    });
}

ResultsFolder::~ResultsFolder()
{
  std::error_code error;
  if (!partial.empty() && is_first_rank())
    fs::remove_all(partial, error);
  if (made_parent)
    fs::remove(target.parent_path(), error); // fails if the folder still contains results
}

void ResultsFolder::open()
{
  partial = from_first_rank([this] { return make_partial_folder(target); });
}

void ResultsFolder::publish()
{
  const fs::path whole = std::exchange(partial, fs::path());
  const std::string older = target.string() + ".older-" + std::to_string(::getpid());
  try
  {
    require_replaceable(target);
    for (const std::string &name : content_of(target).hidden)
    {
      fs::create_directories((whole / name).parent_path());
      fs::rename(target / name, whole / name);
    }
    std::string stamp;
    for (const std::string &name : content_of(whole).others)
      stamp += name + '\n';
    write_text_file(whole / stamp_name, stamp);
    while (::rename(whole.c_str(), target.c_str()) != 0)
    {
      remove_results(older); // results of another run that finished earlier
      fs::rename(target, older);
    }
    remove_results(older);
  }
  catch (const std::exception &failure)
  {
    throw OutputFailure(std::string(failure.what()) + " The results are in " + whole.string() + ".");
  }
}

void require_writable(const fs::path &file)
{
  std::error_code error;
  const fs::file_status status = fs::symlink_status(file, error);
  const bool is_own = fs::is_regular_file(status) && read_text_file(file).find(written_by_stemware) < 512;
  ensure_output(!fs::exists(status) || is_own, file, " exists without a mark of Stemware; remove it or");
  // A check of permissions is not enough, because root has permission even on read-only file systems.
  const std::string probe = partial_name(file);
  ensure_output(file.has_filename() && std::ofstream(probe), file, " cannot be written;");
  std::remove(probe.c_str());
}

void write_output_file(const fs::path &file, const std::string &text)
{
  require_writable(file);
  const std::string partial = partial_name(file);
  write_text_file(partial, text);
  fs::rename(partial, file);
}
} // namespace stemware::pipeline
