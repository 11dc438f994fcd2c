#include "fem/pipeline/study/column_file.h"

#include "fem/pipeline/study/quantity_text.h"
#include "fem/pipeline/support/failures.h"
#include "fem/pipeline/support/numbers.h"
#include "fem/pipeline/support/text_file.h"

#include <boost/algorithm/string/classification.hpp>
#include <boost/algorithm/string/replace.hpp>
#include <boost/algorithm/string/split.hpp>
#include <boost/algorithm/string/trim.hpp>

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <optional>

namespace stemware::pipeline
{

namespace
{

/// Separators of a line's columns: semicolons or tabs, or else commas, or else blanks ("r (mm), z (mm)").
std::string separators_of(const std::string &line)
{
  for (const char *marks : { ";\t", "," })
    if (line.find_first_of(marks) != std::string::npos)
      return marks;
  return " ";
}

std::vector<std::string> cells_of(const std::string &line)
{
  const std::string separators = separators_of(line);
  std::vector<std::string> cells;
  boost::split(cells, line, boost::is_any_of(separators),
               separators == " " ? boost::token_compress_on : boost::token_compress_off);
  for (std::string &cell : cells)
    boost::trim_if(cell, boost::is_any_of(" \"'"));
  return cells;
}

/// The number of a cell, in which the comma of "4,007;3,058" is a decimal one.
std::optional<double> number_in_cell(std::string cell)
{
  if (std::count(cell.begin(), cell.end(), ',') == 1 && cell.find('.') == std::string::npos)
    boost::replace_first(cell, ",", ".");
  return parse_number(cell);
}

/// The unit behind the column's name, "r (mm)", "r [mm]" or "r mm", in units of SI.
std::optional<double> unit_in(const std::string &cell, const FileColumn &column)
{
  const auto end = std::min(cell.find_first_of(" (["), cell.size());
  if (std::find(column.names.begin(), column.names.end(), cell.substr(0, end)) == column.names.end())
    return std::nullopt;
  return parse_quantity("1 " + boost::trim_copy_if(cell.substr(end), boost::is_any_of(" ()[]")), column.unit);
}

} // namespace

std::vector<FileRow> read_column_file(const std::string &setting, const std::string &file,
                                      const std::vector<FileColumn> &columns)
{
  std::vector<std::string> names, header;
  for (const FileColumn &column : columns)
  {
    names.push_back(column.names.front());
    header.push_back(fmt::format(FMT_STRING("{} ({})"), names.back(), usual_units(column.unit).front()));
  }
  std::vector<double> units(columns.size(), 1.);
  bool may_be_header = true;
  std::vector<FileRow> rows;
  for (const TextLine &line : read_lines(setting, file))
  {
    if (line.text.front() == '#')
      continue;
    const std::vector<std::string> cells = cells_of(line.text);
    std::vector<double> numbers, given_units;
    for (std::size_t i = 0; i < cells.size() && cells.size() == columns.size(); ++i)
      if (const auto number = number_in_cell(cells[i]))
        numbers.push_back(*number * units[i]);
      else if (const auto unit = unit_in(cells[i], columns[i]); unit && may_be_header)
        given_units.push_back(*unit);
    if (may_be_header && numbers.empty() && given_units.size() < columns.size() &&
        cells.size() == columns.size())
      throw BadInput(fmt::format(
        FMT_STRING("{}, line {}: the header \"{}\" does not name the columns {} with "
                   "units of theirs; write \"{}\", or leave the header out."),
        setting, line.number, shortened(line.text), fmt::join(names, ", "), fmt::join(header, ", ")));
    may_be_header = false;
    if (given_units.size() == columns.size())
      units = given_units;
    else if (numbers.size() == columns.size())
      rows.push_back({ numbers, line.number });
    else
      throw BadInput(
        fmt::format(FMT_STRING("{}, line {}: \"{}\" is not a row; write {} numbers, {}, in SI units or in "
                               "those of a first line \"{}\"."),
                    setting, line.number, shortened(line.text), columns.size(), fmt::join(names, ", "),
                    fmt::join(header, ", ")));
  }
  require(!rows.empty(), fmt::format(FMT_STRING("{} has no rows; write {} numbers a line, {}."), setting,
                                     columns.size(), fmt::join(names, ", ")));
  return rows;
}

} // namespace stemware::pipeline
