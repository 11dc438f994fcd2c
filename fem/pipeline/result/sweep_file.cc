#include "fem/pipeline/result/sweep_file.h"

#include "fem/pipeline/base/failures.h"
#include "fem/pipeline/base/numbers.h"
#include "fem/pipeline/base/output.h"
#include "fem/pipeline/base/program.h"
#include "fem/pipeline/base/text.h"
#include "fem/pipeline/base/text_file.h"
#include "fem/pipeline/study/study_file.h"
#include "fem/pipeline/study/table_file.h"

#include <cerrno>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <set>
#include <sstream>
#include <sys/stat.h>
#include <system_error>

namespace stemware::pipeline
{

namespace fs = std::filesystem;

namespace
{

constexpr char table_name[] = "sweep.csv";

std::string csv_row(const std::vector<std::string> &cells)
{
  std::string row;
  for (const std::string &cell : cells)
    row += (row.empty() ? "" : ",") + csv_field(on_one_line(cell));
  return row + '\n';
}

std::string headings(const CaseList &list)
{
  std::vector<std::string> cells = { "case" };
  for (const VariedEntry &entry : list.entries)
    cells.push_back(with_unit(entry.path, entry.unit, false));
  for (const Quantity &quantity : sweep_columns())
    cells.push_back(with_unit(quantity.key, quantity.unit, false));
  cells.insert(cells.end(), { "contact_outcome", "status", "message" });
  return csv_row(cells);
}

/// Files that some case reads.
std::set<std::string> files_of_cases(const CaseList &list)
{
  const std::vector<std::string> of_base = files_of(list.base);
  std::set<std::string> files(of_base.begin(), of_base.end());
  Study study;
  const std::vector<StudyEntry> entries = study_entries(study);
  for (std::size_t e = 0; e < list.entries.size(); ++e)
    if (entry_at(entries, "", list.entries[e].path).path_value != nullptr)
      for (const auto &values : list.cases)
        files.insert(values[e]);
  return files;
}

/// The head of sweep.csv. Paths start at the folder: the same sweep may be started from anywhere.
std::string head_of(const fs::path &folder, const CaseList &list)
{
  std::string head = "# stemware " + program_version() + " (" + program_revision() + ")\n";
  std::istringstream study(study_as_prm(with_paths_from(folder, list.base)));
  for (std::string line; std::getline(study, line);)
    head += "# " + line + '\n';
  for (const std::string &file : files_of_cases(list))
    if (struct stat status = {}; ::stat(file.c_str(), &status) == 0)
      head += fmt::format(FMT_STRING("# reads {}: {} bytes of {:%Y-%m-%dT%H:%M:%S}.{:09}Z\n"),
                          on_one_line(fs::relative(file, folder).string()), status.st_size,
                          fmt::gmtime(status.st_mtim.tv_sec), status.st_mtim.tv_nsec);
  return head + headings(list);
}

} // namespace

SweepFile::SweepFile(const fs::path &wanted, const CaseList &list)
    : folder(fs::absolute(wanted).lexically_normal())
    , file(folder / table_name)
    , list(list)
    , head(head_of(folder, list))
{
  require_replaceable(folder);
  const std::string text = read_text_file(file);
  const bool is_begun = head.compare(0, text.size(), text) != 0; // else killed before the first row
  std::error_code error;
  if (is_begun)
  {
    require_head(text);
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

void SweepFile::require_head(const std::string &text) const
{
  std::istringstream there(text), here(head);
  std::string before, now;
  for (unsigned int line = 1; std::getline(here, now); ++line)
    if (!std::getline(there, before) || before != now)
      throw OutputFailure(fmt::format(
        FMT_STRING("{}, line {}: the rows are those of another version, study, file or list of columns, "
                   "\"{}\" there and \"{}\" now; choose another folder with --output."),
        shortened_path(file.string()), line, shortened(before), shortened(now)));
}

void SweepFile::read_rows(const std::string &text)
{
  const std::string place = shortened_path(file.string());
  const TextTable table = parse_table(place, text);
  const std::size_t n_entries = list.entries.size(), n_numbers = sweep_columns().size();
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
    const std::string &status = row->cells[n_entries + n_numbers + 2];
    result.tips_at_rest = !result.message.empty() && status == "tips";
    result.is_formal = status == "formal";
    for (std::size_t q = 0; q < n_numbers; ++q)
      if (const std::string &cell = row->cells[1 + n_entries + q]; !cell.empty())
      {
        const auto value = parse_number(cell);
        if (!value)
          refuse("\"" + shortened(cell) + "\" is not a number");
        result.values[sweep_columns()[q].key] = *value;
      }
    cases[index] = result;
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
  cells.insert(cells.end(), { result.outcome, result.status(), result.message });
  write(csv_row(cells));
  cases[index] = result;
}

} // namespace stemware::pipeline
