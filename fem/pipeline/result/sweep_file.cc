#include "fem/pipeline/result/sweep_file.h"

#include "fem/pipeline/base/failures.h"
#include "fem/pipeline/base/numbers.h"
#include "fem/pipeline/base/output.h"
#include "fem/pipeline/base/program.h"
#include "fem/pipeline/base/text.h"
#include "fem/pipeline/base/text_file.h"
#include "fem/pipeline/study/study_file.h"
#include "fem/pipeline/study/table_file.h"

#include <boost/algorithm/string/replace.hpp>

#include <algorithm>
#include <cerrno>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <set>
#include <sys/stat.h>
#include <system_error>

namespace stemware::pipeline
{

namespace fs = std::filesystem;

namespace
{

std::string csv_row(const std::vector<std::string> &cells)
{
  std::string row;
  for (const std::string &cell : cells)
    row += (row.empty() ? "" : ",") + csv_field(on_one_line(cell));
  return row + '\n';
}

/// Returns the size and the modification time of each input file of the cases, one file per line.
std::string read_files(const fs::path &folder, const CaseList &list)
{
  const std::vector<std::string> of_base = files_of(entries_of(list.base));
  std::set<std::string> files(of_base.begin(), of_base.end());
  for (std::size_t e = 0; e < list.entries.size(); ++e)
    if (entry_at(default_entries(), "", list.entries[e].path).path_value != nullptr)
      for (const auto &values : list.cases)
        files.insert(values[e]);
  std::string lines;
  for (const std::string &file : files)
    if (struct stat status = {}; ::stat(file.c_str(), &status) == 0)
      lines += fmt::format(FMT_STRING("reads {}: {} bytes of {:%Y-%m-%dT%H:%M:%S}.{:09}Z\n"),
                           on_one_line(fs::relative(file, folder).string()), status.st_size,
                           fmt::gmtime(status.st_mtim.tv_sec), status.st_mtim.tv_nsec);
  return lines;
}

/// Returns the head of sweep.csv: the lines that begin with #, and the headings. Paths are relative to @p
/// folder, so that a sweep can be resumed from any working directory.
std::string head_of(const fs::path &folder, const CaseList &list)
{
  std::vector<std::string> headings = { "case" };
  for (const VariedEntry &entry : list.entries)
    headings.push_back(with_unit(entry.path, entry.unit, false));
  for (const Quantity &quantity : sweep_columns())
    headings.push_back(with_unit(quantity.key, quantity.unit, false));
  headings.insert(headings.end(), { "contact_outcome", "status", "message" });
  const std::string study = "stemware " + program_version() + " (" + program_revision() + ")\n" +
                            study_as_prm(with_paths_from(folder, list.base)) + read_files(folder, list);
  return "# " + boost::replace_all_copy(study.substr(0, study.size() - 1), "\n", "\n# ") + '\n' +
         csv_row(headings);
}

void require_head(const std::string &file, const std::string &text, const std::string &head)
{
  const auto differs = std::mismatch(head.begin(), head.end(), text.begin(), text.end());
  if (differs.first == head.end())
    return;
  const auto line_at = [](const std::string &whole, std::string::const_iterator place)
  {
    const auto begin = std::find(std::make_reverse_iterator(place), whole.rend(), '\n').base();
    return shortened({ begin, std::find(place, whole.end(), '\n') });
  };
  throw OutputFailure(fmt::format(
    FMT_STRING("{}, line {}: the rows are those of another version, study, file or list of columns, \"{}\" "
               "there and \"{}\" now; choose another folder with --output."),
    file, 1 + std::count(head.begin(), differs.first, '\n'), line_at(text, differs.second),
    line_at(head, differs.first)));
}

} // namespace

SweepFile::SweepFile(const fs::path &wanted, const CaseList &list)
    : folder(fs::absolute(wanted).lexically_normal())
    , file(folder / "sweep.csv")
    , list(list)
{
  require_replaceable(folder);
  const std::string head = head_of(folder, list), text = read_text_file(file);
  // False if the file is missing, or ends within its head because the program ended before the first row.
  const bool is_begun = head.compare(0, text.size(), text) != 0;
  std::error_code error;
  if (is_begun)
  {
    require_head(shortened_path(file.string()), text, head);
    const std::size_t n_whole = text.rfind('\n') + 1;
    read_rows(text.substr(0, n_whole));
    fs::resize_file(file, n_whole, error);
  }
  else
  {
    if (fs::exists(folder / "summary.json") && !fs::exists(file))
      throw OutputFailure("The folder " + shortened_path(folder.string()) +
                          " holds other results, but no sweep.csv; choose another folder with --output.");
    fs::create_directories(folder, error);
    if (!error)
      write_text_file(folder / stamp_name,
                      "sweep.csv\nsummary.json\nparameters.prm\nreport.html\ntimings.json\n");
  }
  if (!error)
    stream.open(file, is_begun ? std::ios::app : std::ios::trunc);
  if (error || !stream)
    throw OutputFailure(fmt::format(
      FMT_STRING("The file {} cannot be written ({}); choose another folder with --output."),
      shortened_path(file.string()), error ? error.message() : std::generic_category().message(errno)));
  if (!is_begun)
    write(head);
}

void SweepFile::read_rows(const std::string &text)
{
  const std::string place = shortened_path(file.string());
  const TextTable table = parse_table(place, text);
  const std::size_t first_number = 1 + list.entries.size(), n_numbers = sweep_columns().size();
  for (auto row = table.rows.begin() + 1; row != table.rows.end(); ++row)
  {
    const std::vector<std::string> &cells = row->cells;
    const std::size_t number = parse_count(cells.front()).value_or(0);
    const bool is_known =
      1 <= number && number <= list.cases.size() && cells.size() == first_number + n_numbers + 3 &&
      std::equal(cells.begin() + 1, cells.begin() + static_cast<std::ptrdiff_t>(first_number),
                 list.cases[number - 1].begin(),
                 [](const std::string &there, const std::string &now) { return there == on_one_line(now); });
    if (!is_known)
      throw OutputFailure(fmt::format(
        FMT_STRING("{}, line {}: \"{}\" is no case of this sweep; choose another folder with --output, or "
                   "remove the line and let its case be solved again."),
        place, row->line, shortened(csv_row(cells))));
    CaseResult &result =
      cases[number - 1] = { cells[first_number + n_numbers], *(cells.end() - 2), cells.back() };
    for (std::size_t q = 0; q < n_numbers; ++q)
      if (const auto value = parse_number(cells[first_number + q]))
        result.values[sweep_columns()[q].key] = *value;
  }
}

void SweepFile::write(const std::string &text)
{
  if (!(stream << text << std::flush))
    throw OutputFailure(fmt::format(
      FMT_STRING("The file {} cannot be written ({}); free some space and run the same command again to "
                 "continue."),
      shortened_path(file.string()), std::generic_category().message(errno)));
}

void SweepFile::append(std::size_t index, const CaseResult &result)
{
  std::vector<std::string> cells = { std::to_string(index + 1) };
  cells.insert(cells.end(), list.cases[index].begin(), list.cases[index].end());
  for (const Quantity &quantity : sweep_columns())
  {
    const auto value = result.value(quantity.key);
    cells.push_back(value ? to_text(*value) : "");
  }
  cells.insert(cells.end(), { result.outcome, result.status, result.message });
  write(csv_row(cells));
  cases[index] = result;
}

} // namespace stemware::pipeline
