#include "fem/pipeline/document/sweep_file.h"

#include "fem/pipeline/input/study_file.h"
#include "fem/pipeline/study/table_file.h"
#include "fem/pipeline/support/failures.h"
#include "fem/pipeline/support/json.h"
#include "fem/pipeline/support/numbers.h"
#include "fem/pipeline/support/text.h"
#include "fem/pipeline/system/json_text.h"
#include "fem/pipeline/system/output.h"
#include "fem/pipeline/system/program.h"
#include "fem/pipeline/system/text_file.h"

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <fcntl.h>
#include <fmt/format.h>
#include <set>
#include <sys/file.h>
#include <system_error>
#include <unistd.h>

namespace stemware::pipeline
{

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace
{

constexpr char study_name[] = "study.json", table_name[] = "sweep.csv", sorted_name[] = "sweep.csv.sorted";

std::string csv_row(const std::vector<std::string> &cells)
{
  std::string row;
  for (const std::string &cell : cells)
    row += (row.empty() ? "" : ",") + csv_field(on_one_line(cell));
  return row + '\n';
}

std::string header_of(const CaseList &list)
{
  std::vector<std::string> keys;
  for (const Quantity &column : sweep_columns(list))
    keys.push_back(with_unit(column.key, column.unit, false));
  return csv_row(keys);
}

/// FNV-1a of the content of a file; tells a changed file from the one that finished cases have read.
std::string digest(const std::string &file)
{
  std::uint64_t hash = 14695981039346656037u;
  for (const char byte : read_text_file(file))
    hash = (hash ^ static_cast<unsigned char>(byte)) * 1099511628211u;
  return fmt::format(FMT_STRING("{:016x}"), hash);
}

/// Digests of the files that some case reads, by their paths from @p folder.
Json digests(const fs::path &folder, const CaseList &list)
{
  std::set<std::string> files;
  for (const std::string &file : files_of(list.base))
    files.insert(file);
  Study study;
  const std::vector<StudyEntry> entries = study_entries(study);
  for (std::size_t e = 0; e < list.entries.size(); ++e)
    if (const StudyEntry &entry = entry_at(entries, "", list.entries[e].path); entry.path_value != nullptr)
      for (const auto &values : list.cases)
        files.insert(values[e]);
  Json json = Json::object();
  for (const std::string &file : files)
    json[fs::relative(file, folder).string()] = digest(file);
  return json;
}

/// Content of study.json. Paths start at the folder: the same sweep may be started from anywhere.
Json study_of_sweep(const fs::path &folder, const CaseList &list)
{
  Json columns = Json::array();
  for (const Quantity &column : sweep_columns(list))
    columns.push_back({ { "key", column.key }, { "unit", column.unit }, { "label", column.heading } });
  const Json study = { { "program",
                         { { "version", program_version() }, { "revision", program_revision() } } },
                       { "parameters", study_as_json(with_paths_from(folder, list.base)) },
                       { "columns", columns },
                       { "files", digests(folder, list) } };
  // Names of files may be no UTF-8, of which JSON is made.
  return Json::parse(study.dump(-1, ' ', false, Json::error_handler_t::replace));
}

/// First difference of two studies of a sweep, for a sentence that begins with the folder; empty if there is
/// none. Files that only one of them names do not count.
std::string difference(const Json &before, const Json &now)
{
  if (before.value("program", Json()) != now["program"])
    return "holds a sweep of another version of Stemware";
  for (const auto &[section, entries] : now["parameters"].items())
    for (const auto &[name, value] : entries.items())
      if (const Json old =
            before.value("parameters", Json::object()).value(section, Json::object()).value(name, Json());
          old != value)
        return fmt::format(FMT_STRING("holds a sweep of another study ({}/{} = {} there, {} here)"), section,
                           name, shortened(old.dump(), 40), shortened(value.dump(), 40));
  if (before.value("columns", Json()) != now["columns"])
    return "holds a sweep with other columns";
  for (const auto &[file, hash] : now["files"].items())
    if (before.value("files", Json::object()).value(file, hash) != hash)
      return "holds a sweep that read another content of " + shortened_path(file);
  return "";
}

} // namespace

std::vector<Quantity> sweep_columns(const CaseList &list)
{
  std::vector<Quantity> columns = { quantity_named("case", "sweep.csv") };
  for (const VariedEntry &entry : list.entries)
  {
    const std::string name = entry.path.substr(entry.path.find('/') + 1);
    columns.push_back({ entry.path, entry.path, entry.unit, name, name });
  }
  std::vector<std::string> keys = sweep_keys();
  keys.insert(keys.end(), { "contact_outcome", "status", "message" });
  for (const std::string &key : keys)
    columns.push_back(quantity_named(key, "sweep.csv"));
  return columns;
}

SweepFile::SweepFile(const fs::path &wanted, const CaseList &list)
    : folder(resolved_output(wanted))
    , list(list)
    , header(header_of(list))
{
  const auto refuse = [&](const std::string &trouble)
  {
    throw OutputFailure("The folder " + shortened_path(folder.string()) + " " + trouble +
                        "; choose another one with --output.");
  };
  require_replaceable(folder, study_name);
  std::error_code error;
  fs::create_directories(folder, error);
  if (error)
    refuse("cannot be made (" + error.message() + ")");
  const std::string rows = read_text_file(folder / table_name);
  const bool is_begun = rows.find('\n') != rows.npos; // else the program was killed before its first row
  const Json study = Json::parse(dump_utf8(study_of_sweep(folder, list)));
  if (is_begun)
  {
    const Json before = json_in(read_text_file(folder / study_name)).value_or(Json::object());
    if (const std::string trouble = difference(before.is_object() ? before : Json::object(), study);
        !trouble.empty())
      refuse(trouble);
    if (rows.compare(0, header.size(), header) != 0)
      refuse("holds a sweep with other columns");
    read_rows(rows);
  }
  else // before sweep.csv: a folder without study.json is no sweep's
    write_text_file(folder / study_name, dump_utf8(study, 2) + '\n');
  open();
  const std::size_t n_whole = is_begun ? rows.rfind('\n') + 1 : 0;
  if (::ftruncate(descriptor, static_cast<off_t>(n_whole)) != 0)
    refuse("cannot be written (" + std::generic_category().message(errno) + ")");
  if (!is_begun)
    write(header);
}

SweepFile::~SweepFile()
{
  if (descriptor >= 0)
    ::close(descriptor);
}

void SweepFile::open()
{
  const std::string place = shortened_path((folder / table_name).string());
  descriptor =
    ::open((folder / table_name).c_str(), O_RDWR | O_CREAT | O_APPEND | O_NOFOLLOW | O_CLOEXEC, 0666);
  if (descriptor < 0)
    throw OutputFailure("The file " + place + " cannot be written (" +
                        std::generic_category().message(errno) + "); choose another folder with --output.");
  if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
    throw OutputFailure("Another sweep writes into " + place +
                        "; wait for it, or choose another folder with --output.");
}

void SweepFile::read_rows(const std::string &text)
{
  const std::string place = shortened_path((folder / table_name).string());
  const TextTable table = parse_table(place, text.substr(0, text.rfind('\n') + 1));
  const std::size_t n_entries = list.entries.size(), n_numbers = sweep_keys().size();
  for (auto row = table.rows.begin() + 1; row != table.rows.end(); ++row)
  {
    const auto refuse = [&](const std::string &trouble)
    {
      throw OutputFailure(fmt::format(FMT_STRING("{}, line {}: {}; choose another folder with --output, or "
                                                 "remove the line and let it be solved again."),
                                      place, row->line, trouble));
    };
    const auto number = parse_count(row->cells.front());
    if (!number || row->cells.size() != n_entries + n_numbers + 4)
      refuse("this is no row of a sweep");
    if (*number < 1 || *number > list.cases.size())
      refuse(fmt::format(FMT_STRING("there are {} cases, but this is case {}"), list.cases.size(), *number));
    const std::size_t index = *number - 1;
    for (std::size_t e = 0; e < n_entries; ++e)
      if (row->cells[1 + e] != on_one_line(list.cases[index][e]))
        refuse(fmt::format(FMT_STRING("case {} has {} = {} there, {} now"), *number, list.entries[e].path,
                           shortened(row->cells[1 + e]), shortened(list.cases[index][e])));
    CaseResult result = { row->cells[n_entries + n_numbers + 1], row->cells.back() };
    for (std::size_t q = 0; q < n_numbers; ++q)
      if (const std::string &cell = row->cells[1 + n_entries + q]; !cell.empty())
      {
        const auto value = parse_number(cell);
        if (!value)
          refuse("\"" + shortened(cell) + "\" is not a number");
        result.values[sweep_keys()[q]] = *value;
      }
    cases[index] = result;
  }
}

std::string SweepFile::row_of(std::size_t index, const CaseResult &result) const
{
  std::vector<std::string> cells = { std::to_string(index + 1) };
  cells.insert(cells.end(), list.cases[index].begin(), list.cases[index].end());
  for (const std::string &key : sweep_keys())
  {
    const auto value = result.value(key);
    cells.push_back(value ? to_text(*value) : "");
  }
  cells.insert(cells.end(), { result.outcome, result.status(), result.message });
  return csv_row(cells);
}

void SweepFile::write(const std::string &text)
{
  for (std::size_t n_written = 0; n_written < text.size();)
  {
    const ssize_t n = ::write(descriptor, text.data() + n_written, text.size() - n_written);
    if (n < 0 && errno == EINTR)
      continue;
    if (n < 0)
      throw OutputFailure(fmt::format(
        FMT_STRING(
          "The file {} cannot be written ({}); free some space and run the same command again to continue."),
        shortened_path((folder / table_name).string()), std::generic_category().message(errno)));
    n_written += static_cast<std::size_t>(n);
  }
}

void SweepFile::append(std::size_t index, const CaseResult &result)
{
  write(row_of(index, result));
  cases[index] = result;
}

void SweepFile::sort()
{
  std::string text = header;
  for (const auto &[index, result] : cases)
    text += row_of(index, result);
  write_text_file(folder / sorted_name, text);
  std::error_code error;
  fs::rename(folder / sorted_name, folder / table_name, error);
  if (error)
    throw OutputFailure("The file " + shortened_path((folder / table_name).string()) +
                        " cannot be written (" + error.message() + "); run the same command again.");
}

} // namespace stemware::pipeline
