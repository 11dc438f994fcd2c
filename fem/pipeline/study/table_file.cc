#include "fem/pipeline/study/table_file.h"

#include "fem/pipeline/base/failures.h"

#include <boost/algorithm/string/classification.hpp>
#include <boost/algorithm/string/predicate.hpp>
#include <boost/algorithm/string/trim.hpp>

#include <algorithm>
#include <optional>

namespace stemware::pipeline
{

namespace
{

/// Returns the separator of the cells in the row that starts at @p begin; '\n' if the row has a single cell.
char separator_of(const std::string &text, std::size_t begin, bool blanks_separate)
{
  std::string row;
  bool is_quoted = false;
  for (std::size_t i = begin; i < text.size() && (is_quoted || text[i] != '\n'); ++i)
    if (text[i] == '"')
      is_quoted = !is_quoted;
    else if (!is_quoted)
      row += text[i];
  boost::trim(row);
  for (const char candidate : { ';', '\t', ',' })
    if (row.find(candidate) != std::string::npos)
      return candidate;
  return blanks_separate ? ' ' : '\n';
}

/// Returns the separator in a first line such as "sep=;" (a convention of Excel), otherwise std::nullopt.
std::optional<char> named_separator(const std::string &origin, const std::string &text)
{
  const std::string line = boost::trim_right_copy_if(text.substr(0, text.find('\n')), boost::is_any_of("\r"));
  if (!boost::istarts_with(line, "sep="))
    return std::nullopt;
  if (line.size() != 5 || std::string(";,\t").find(line.back()) == std::string::npos)
    throw BadInput(origin + ", line 1: the separator \"" + line.substr(4, 20) +
                   "\" is not known; separate the cells by semicolons, commas or tabs.");
  return line.back();
}

/// Reads the row that begins at @p place of @p text, in the line @p line, and moves both behind the row.
TableRow<std::string> read_row(const std::string &origin, const std::string &text, char separator,
                               std::size_t &place, unsigned int &line)
{
  TableRow<std::string> row = { { "" }, line };
  bool is_quoted = false, has_quotes = false; // of the present cell
  unsigned int quote_line = line;
  while (place < text.size())
  {
    std::string &cell = row.cells.back();
    const char letter = text[place++];
    line += letter == '\n' ? 1 : 0;
    if (is_quoted && letter == '"' && text.compare(place, 1, "\"") != 0)
      is_quoted = false;
    else if (is_quoted)
    {
      cell += letter;
      place += letter == '"' ? 1 : 0; // a doubled quote
    }
    else if (letter == '\n')
      break;
    else if (letter == separator || (separator == ' ' && letter == '\t'))
    {
      row.cells.emplace_back();
      has_quotes = false;
    }
    else if (letter == '"' && boost::trim_copy(cell).empty() && !has_quotes)
    {
      is_quoted = has_quotes = true;
      quote_line = line;
      cell.clear();
    }
    else
      cell += letter;
  }
  ensure(!is_quoted, origin + ", line " + std::to_string(quote_line) +
                       ": a quote is not closed; write a quote within a cell twice, or remove it.");
  for (std::string &cell : row.cells)
    boost::trim(cell);
  if (separator == ' ') // several blanks count as one separator
    row.cells.erase(std::remove(row.cells.begin(), row.cells.end(), ""), row.cells.end());
  return row;
}

} // namespace

std::string with_decimal_point(std::string cell)
{
  const auto comma = cell.find(',');
  if (comma != std::string::npos && cell.find_first_of(",.", comma + 1) == cell.npos &&
      cell.find('.') == cell.npos)
    cell[comma] = '.';
  return cell;
}

TextTable parse_table(const std::string &origin, const std::string &text, bool blanks_separate)
{
  const std::optional<char> named = named_separator(origin, text);
  TextTable table;
  unsigned int line = 1;
  for (std::size_t place = 0; place < text.size();)
  {
    const std::size_t first = text.find_first_not_of(" \t\r", place);
    if (first == text.npos || text[first] == '\n' || text[first] == '#' || (named && line == 1))
    {
      place = std::min(text.find('\n', place), text.size() - 1) + 1;
      ++line;
      continue;
    }
    if (table.rows.empty())
      table.separator = named ? *named : separator_of(text, place, blanks_separate);
    table.rows.push_back(read_row(origin, text, table.separator, place, line));
  }
  return table;
}

std::pair<std::string, std::string> parse_heading(const std::string &cell)
{
  const bool is_round = !cell.empty() && cell.back() == ')', is_square = !cell.empty() && cell.back() == ']';
  const auto begin = is_round ? cell.rfind('(') : is_square ? cell.rfind('[') : cell.npos;
  if (begin == cell.npos)
    return { cell, "" };
  return { boost::trim_copy(cell.substr(0, begin)),
           boost::trim_copy(cell.substr(begin + 1, cell.size() - begin - 2)) };
}

std::string position_in_table(const std::string &setting, unsigned int line, std::size_t column)
{
  return setting + ", line " + std::to_string(line) + ", column " + std::to_string(column + 1) + ": ";
}

} // namespace stemware::pipeline
