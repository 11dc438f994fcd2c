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

class TableReader
{
public:
  TableReader(const std::string &origin, const std::string &text)
      : origin(origin)
      , text(text)
  {
  }

  TextTable read(bool blanks_separate)
  {
    const std::optional<char> named = named_separator(origin, text);
    if (named)
      skip_line();
    while (skip_to_row())
    {
      if (table.rows.empty())
        table.separator = named ? *named : separator_of(text, place, blanks_separate);
      read_row();
    }
    return table;
  }

private:
  bool at_end() const { return place == text.size(); }

  char next()
  {
    line += text[place] == '\n' ? 1 : 0;
    return text[place++];
  }

  /// Moves to the next row, past blank lines and comments. Returns false at the end of the text.
  bool skip_to_row()
  {
    while (!at_end())
    {
      const std::size_t first = text.find_first_not_of(" \t\r", place);
      if (first != text.npos && text[first] != '\n' && text[first] != '#')
        return true;
      skip_line();
    }
    return false;
  }

  void skip_line()
  {
    while (!at_end() && next() != '\n')
      ;
  }

  void read_row()
  {
    TableRow<std::string> row = { {}, line };
    bool is_last = false;
    while (!is_last)
      row.cells.push_back(read_cell(is_last));
    if (table.separator == ' ') // several blanks count as one separator
      row.cells.erase(std::remove(row.cells.begin(), row.cells.end(), ""), row.cells.end());
    table.rows.push_back(row);
  }

  /// Reads a cell and its separator; returns the cell. Sets @p is_last to true at the end of the row.
  std::string read_cell(bool &is_last)
  {
    std::string cell;
    bool has_quotes = false;
    while (!at_end())
    {
      const char letter = next();
      is_last = letter == '\n';
      if (is_last || letter == table.separator || (table.separator == ' ' && letter == '\t'))
        return boost::trim_copy(cell);
      if (letter == '"' && boost::trim_copy(cell).empty() && !has_quotes)
      {
        has_quotes = true;
        cell = read_quoted();
      }
      else
        cell += letter;
    }
    is_last = true;
    return boost::trim_copy(cell);
  }

  std::string read_quoted()
  {
    const unsigned int first_line = line;
    std::string quoted;
    while (!at_end())
    {
      const char letter = next();
      if (letter != '"')
        quoted += letter;
      else if (!at_end() && text[place] == '"')
        quoted += next();
      else
        return quoted;
    }
    throw BadInput(origin + ", line " + std::to_string(first_line) +
                   ": a quote is not closed; write a quote within a cell twice, or remove it.");
  }

  const std::string &origin, &text;
  std::size_t place = 0;
  unsigned int line = 1;
  TextTable table;
};

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
  return TableReader(origin, text).read(blanks_separate);
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
