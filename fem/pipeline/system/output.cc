#include "fem/pipeline/system/output.h"

#include "fem/pipeline/support/failures.h"
#include "fem/pipeline/support/text.h"
#include "fem/pipeline/system/console.h"
#include "fem/pipeline/system/json_text.h"
#include "fem/pipeline/system/ranks.h"
#include "fem/pipeline/system/text_file.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <fmt/format.h>
#include <fstream>
#include <iterator>
#include <optional>
#include <ostream>
#include <set>
#include <sstream>
#include <string_view>
#include <sys/stat.h>
#include <unistd.h>

namespace stemware::pipeline
{

namespace fs = std::filesystem;

namespace
{

// The names of all results: publish() refuses others.
constexpr char result_files[] =
  "summary.json timings.json parameters.prm report.html harmonics.dat study.json manifest.json "
  "load.csv rings.csv budget.csv without.csv torque.csv spin_up.csv truncation.csv "
  "driven_spin_up.csv phases.csv load_lines.csv footprint.csv footprint_at_end.csv "
  "contact_history.csv converge.csv fit.csv sweep.csv sweep.csv.sorted figures/style.gnuplot "
  "fields/contact.vtu fields/contact.pvtu fields/contact_at_terminal_spin.vtu";
// Pictures of earlier versions: their folders of results can be replaced.
constexpr char figures[] =
  "glass orbits waterfall effects load slip spectrum line_load higher_harmonics spin_up "
  "harmonic_torque torque phases driven_spin_up orbit_speed section_stress foot_from_above section "
  "rim truncation footprint footprint_at_end convergence omega_terminal harmonic_effect "
  "contact_fraction tau_at_rest";

std::vector<std::string> words_of(const std::string &text)
{
  std::istringstream stream(text);
  return { std::istream_iterator<std::string>(stream), {} };
}

std::set<std::string> made_result_names()
{
  std::set<std::string> names;
  for (const std::string &name : words_of(result_files))
    names.insert(name);
  for (const std::string &name : words_of(figures))
    for (const char *extension : { ".svg", ".pdf", ".gp", ".dat" })
      names.insert("figures/" + name + extension);
  return names;
}

bool is_taken(const fs::path &path)
{
  std::error_code error;
  return fs::exists(fs::symlink_status(path, error));
}

bool is_plain_folder(const fs::path &path)
{
  return fs::symlink_status(path).type() == fs::file_type::directory;
}

/// A name in @p folder that verbs do not write, if there is one; @p prefix is "figures/" in that folder.
std::optional<std::string> foreign_name(const fs::path &folder, const std::string &prefix = "")
{
  for (const auto &item : fs::directory_iterator(folder))
  {
    const std::string name = prefix + item.path().filename().string();
    const auto type = item.symlink_status().type();
    if (type == fs::file_type::directory && (name == "figures" || name == "fields"))
    {
      if (const auto inner = foreign_name(item, name + "/"))
        return inner;
    }
    else if (type != fs::file_type::regular || !is_result_name(name))
      return name;
  }
  return std::nullopt;
}

/// Removes results by their names; anything else that has come into @p folder stays, and the folder then too.
void remove_results(const fs::path &folder, const std::string &prefix = "")
{
  std::vector<fs::path> items;
  std::error_code error;
  for (const auto &item : fs::directory_iterator(folder, error))
    items.push_back(item.path());
  for (const fs::path &item : items)
  {
    const std::string name = prefix + item.filename().string();
    if (is_plain_folder(item) && (name == "figures" || name == "fields"))
      remove_results(item, name + "/");
    else if (is_result_name(name))
      ::unlink(item.c_str());
  }
  ::rmdir(folder.c_str());
}

[[noreturn]] void fail_to_write(const fs::path &path, const std::error_code &error)
{
  throw OutputFailure(
    fmt::format(FMT_STRING("The results cannot be written to {} ({}); choose another folder with --output."),
                shortened_path(path.string()), error.message()));
}

/// A renamed folder takes the working folder with it.
void require_not_around_working_folder(const fs::path &target)
{
  const fs::path inside = fs::current_path().lexically_relative(target);
  if (!inside.empty() && *inside.begin() != "..")
    throw OutputFailure("The output folder " + shortened_path(target.string()) +
                        (inside == "." ? " is" : " is around") +
                        " the folder where the program was started, which it does not replace; choose "
                        "another one: --output results.");
}

/// Names the partial folders beside @p target that other runs have made.
void name_leftovers(const fs::path &target)
{
  const std::string prefix = target.filename().string() + ".partial-";
  std::vector<std::string> names;
  std::error_code error;
  for (const auto &item : fs::directory_iterator(target.parent_path(), error))
    if (const std::string name = item.path().filename(); name.rfind(prefix, 0) == 0)
      names.push_back(on_one_line(name));
  std::sort(names.begin(), names.end());
  if (!names.empty())
    console()
      << wrapped(
           fmt::format(
             FMT_STRING(
               "{} in {}: left by a killed run, or in use by a running one; delete it if no run is active."),
             listed(names, "and"), shortened_path(target.parent_path().string())),
           "Remark    ")
      << std::endl;
}

/// "PATH.partial-PID", or with a number behind it: a name that is free.
std::string partial_name(const fs::path &path)
{
  const std::string name = path.string() + ".partial-" + std::to_string(::getpid());
  std::string free = name;
  for (unsigned int n = 2; is_taken(free); ++n)
    free = name + "-" + std::to_string(n);
  return free;
}

/// Whether there is a plain file at @p file that says who wrote it.
bool is_own_file(const fs::path &file)
{
  std::error_code error;
  if (fs::symlink_status(file, error).type() != fs::file_type::regular)
    return false;
  std::string beginning(512, '\0');
  std::ifstream(file, std::ios::binary)
    .read(beginning.data(), static_cast<std::streamsize>(beginning.size()));
  return beginning.find(written_by_stemware) != std::string::npos;
}

} // namespace

bool is_result_name(const std::string &name)
{
  static const std::set<std::string> names = made_result_names();
  // One of several ranks writes fields/contact_3.vtu.
  constexpr std::string_view piece = "fields/contact_";
  const std::size_t rank = name.rfind(piece, 0) == 0 ? piece.size() : name.size();
  const std::size_t rest = name.find_first_not_of("0123456789", rank);
  return names.count(name) > 0 || (rest != std::string::npos && rest > rank && name.substr(rest) == ".vtu");
}

fs::path resolved_output(const fs::path &path)
try
{
  fs::path whole = fs::absolute(path);
  if (!whole.has_filename())
    whole = whole.parent_path();
  const fs::path name = whole.filename();
  const bool is_plain = !name.empty() && name != "." && name != "..";
  fs::path result = is_plain ? fs::weakly_canonical(whole.parent_path()) / name : fs::weakly_canonical(whole);
  if (!is_utf8(result.string()))
    throw OutputFailure("The path of the output " + shortened_path(path.string()) +
                        " is not in UTF-8; choose another place with --output.");
  return result;
}
catch (const fs::filesystem_error &error)
{
  fail_to_write(path, error.code());
}

void require_replaceable(const fs::path &folder, const std::string &mark)
{
  const auto refuse = [&](const std::string &reason)
  {
    throw OutputFailure("The output " + shortened_path(folder.string()) + " " + reason +
                        "; move it away, or choose another folder with --output.");
  };
  const fs::file_status status = fs::symlink_status(folder);
  if (!fs::exists(status))
    return;
  if (fs::is_symlink(status))
    refuse("is a link, not a folder");
  if (!fs::is_directory(status))
    refuse("exists and is not a folder");
  if (const auto name = foreign_name(folder))
    refuse("holds " + shortened(*name) + ", which Stemware never writes");
  if (!fs::is_empty(folder) && !fs::exists(folder / mark))
    refuse("holds " + shortened(fs::directory_iterator(folder)->path().filename().string()) + " but no " +
           mark + ", so it is no folder of finished results");
}

ResultsFolder::ResultsFolder(const fs::path &wanted)
    : target(resolved_output(wanted))
{
  on_first_rank(
    [this]
    {
      try
      {
        require_not_around_working_folder(target);
        require_replaceable(target);
        name_leftovers(target);
        make_partial();
        if (fs::exists(target) && fs::is_empty(target))
          fs::rename(partial, target); // fails for a mount point
        remove_partial();
      }
      catch (const fs::filesystem_error &error)
      {
        remove_partial();
        fail_to_write(target, error.code());
      }
    });
}

ResultsFolder::~ResultsFolder()
{
  if (is_first_rank())
    remove_partial();
}

void ResultsFolder::open()
{
  partial = from_first_rank(
    [this]
    {
      try
      {
        make_partial();
      }
      catch (const fs::filesystem_error &error)
      {
        fail_to_write(target, error.code());
      }
      return partial.string();
    });
}

void ResultsFolder::make_partial()
{
  for (fs::path path = target.parent_path(); !fs::exists(path); path = path.parent_path())
    created_parents.push_back(path);
  fs::create_directories(target.parent_path());
  const std::string name = partial_name(target);
  if (::mkdir(name.c_str(), 0777) != 0)
    throw fs::filesystem_error("mkdir", name, std::error_code(errno, std::generic_category()));
  partial = name;
}

void ResultsFolder::remove_partial() noexcept
{
  std::error_code error;
  if (!partial.empty())
    fs::remove_all(partial, error);
  partial.clear();
  for (const fs::path &parent : created_parents)
    if (::rmdir(parent.c_str()) != 0 && errno != ENOENT)
      break;
  created_parents.clear();
}

void ResultsFolder::publish()
{
  if (const auto name = foreign_name(partial))
    throw std::logic_error("A verb writes " + *name + ", which is not listed in system/output.cc.");
  fs::path whole;
  whole.swap(partial); // from here on it is removed by nobody
  created_parents.clear();
  const std::string place = " The results are in " + whole.string() + ".";
  const fs::path older = whole.string() + ".replaced";
  // Another run may replace the folder between two of these calls: its results are then the older ones.
  constexpr unsigned int max_attempts = 10;
  for (unsigned int n_attempts = 1;; ++n_attempts)
    try
    {
      require_replaceable(target);
      if (fs::exists(target) && !fs::is_empty(target))
        fs::rename(target, older);
      fs::rename(whole, target);
      if (fs::exists(older))
        remove_results(older);
      return;
    }
    catch (const OutputFailure &failure)
    {
      if (n_attempts == max_attempts)
        throw OutputFailure(failure.what() + place);
    }
    catch (const fs::filesystem_error &error)
    {
      std::error_code no_error;
      if (fs::exists(older, no_error) && fs::exists(target, no_error))
        remove_results(older);
      if (n_attempts == max_attempts)
        throw OutputFailure(fmt::format(FMT_STRING("{} cannot be replaced ({}).{}"),
                                        shortened_path(target.string()), error.code().message(), place));
    }
}

void require_writable(const fs::path &file)
{
  if (is_taken(file) && !is_own_file(file))
    throw OutputFailure("The file " + shortened_path(file.string()) +
                        " exists without a mark of Stemware and is not overwritten; choose another name, or "
                        "remove it.");
  // Root may write where the system cannot, so permissions are no answer.
  const std::string probe = partial_name(file);
  std::FILE *const stream = file.has_filename() ? std::fopen(probe.c_str(), "wxe") : nullptr;
  if (stream == nullptr)
    throw OutputFailure(fmt::format(FMT_STRING("The file {} cannot be written ({}); choose another place."),
                                    shortened_path(file.string()),
                                    std::generic_category().message(file.has_filename() ? errno : ENOENT)));
  std::fclose(stream);
  std::remove(probe.c_str());
}

void write_output_file(const fs::path &file, const std::string &text)
{
  require_writable(file);
  const std::string partial = partial_name(file);
  try
  {
    write_text_file(partial, text);
    require_writable(file);
    fs::rename(partial, file);
  }
  catch (const std::exception &)
  {
    std::remove(partial.c_str());
    throw;
  }
}

} // namespace stemware::pipeline
