#pragma once

#include <algorithm>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace stemware::test
{

/// Returns the fields of a table in the format of RFC 4180, line by line, without lines that start with #.
/// Throws std::runtime_error if @p text does not end with a line end.
inline std::vector<std::vector<std::string>> parse_csv(const std::string &text)
{
  std::vector<std::vector<std::string>> rows = { { "" } };
  bool is_quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i)
  {
    if (text[i] == '#' && (i == 0 || (text[i - 1] == '\n' && !is_quoted)))
      i = text.find('\n', i);
    else if (text[i] == '"' && is_quoted && text.compare(i, 2, "\"\"") == 0)
      rows.back().back() += text[i++];
    else if (text[i] == '"')
      is_quoted = !is_quoted;
    else if (is_quoted)
      rows.back().back() += text[i];
    else if (text[i] == ',')
      rows.back().emplace_back();
    else if (text[i] == '\n')
      rows.push_back({ "" });
    else if (text.compare(i, 2, "\r\n") == 0 && ++i)
      rows.push_back({ "" });
    else
      rows.back().back() += text[i];
  }
  if (rows.back() != std::vector<std::string>{ "" })
    throw std::runtime_error("the last line of the table has no end");
  rows.pop_back();
  return rows;
}

/// Returns the lines of sweep.csv, without lines that start with #, sorted by case. The program writes rows
/// in the order in which cases finish.
inline std::string sorted_by_case(const std::string &text)
{
  std::istringstream stream(text);
  std::string headings;
  std::map<int, std::string> rows;
  for (std::string line; std::getline(stream, line);)
    if (line.rfind("case,", 0) == 0)
      headings = line + '\n';
    else if (line[0] != '#')
      rows[std::stoi(line)] = line + '\n';
  for (const auto &[number, row] : rows)
    headings += row;
  return headings;
}

class CsvTable
{
public:
  explicit CsvTable(const std::string &text)
      : rows(parse_csv(text))
  {
  }

  std::size_t n_rows() const { return rows.size() - 1; }

  const std::string &text(std::size_t row, const std::string &title) const
  {
    const auto column = std::find(rows[0].begin(), rows[0].end(), title);
    if (column == rows[0].end())
      throw std::runtime_error("the table has no column " + title);
    return rows.at(row + 1).at(static_cast<std::size_t>(column - rows[0].begin()));
  }

  double number(std::size_t row, const std::string &title) const { return std::stod(text(row, title)); }

private:
  const std::vector<std::vector<std::string>> rows;
};

} // namespace stemware::test
