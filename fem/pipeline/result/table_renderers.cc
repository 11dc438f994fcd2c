#include "fem/pipeline/base/numbers.h"
#include "fem/pipeline/base/text.h"
#include "fem/pipeline/result/number_format.h"
#include "fem/pipeline/result/results.h"

#include <boost/algorithm/string/trim.hpp>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <sstream>

namespace stemware::pipeline
{

namespace
{

constexpr std::size_t margin = 2; ///< number of blanks before each column

std::vector<std::string> header_of(const Quantity &quantity)
{
  const bool has_unit = !quantity.unit.empty() && quantity.unit != "1";
  std::istringstream stream(boost::trim_copy(quantity.label) + (has_unit ? "\n(" + quantity.unit + ")" : ""));
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);)
    lines.push_back(line);
  return lines;
}

/// Returns a cell as text for console or page; @p missing for a missing value.
std::string shown(const Quantity &quantity, const Json &cell, const std::string &missing)
{
  if (cell.is_number_float() && std::isfinite(cell.get<double>()))
    return format::number(cell, quantity.digits);
  if (cell.is_number_integer())
    return cell.dump();
  if (cell.is_string())
    return cell;
  if (cell.is_boolean())
    return cell.get<bool>() ? "yes" : "no";
  return missing;
}

/// Lines of a column, all equally wide. The header is aligned at the bottom.
struct LaidOutColumn
{
  LaidOutColumn(const Column &column, std::size_t n_header_lines)
  {
    const std::vector<std::string> header = header_of(column.quantity);
    lines.assign(n_header_lines - header.size(), "");
    lines.insert(lines.end(), header.begin(), header.end());
    for (std::size_t row = 0; row < column.cells.size(); ++row)
      lines.push_back(shown(column.quantity, column.cells[row], "-"));
    for (const std::string &line : lines)
      width = std::max(width, display_width(line) + margin);
    const bool is_text =
      column.quantity.unit.empty() && std::any_of(column.cells.begin(), column.cells.end(),
                                                  [](const auto &cell) { return cell.is_string(); });
    for (std::string &line : lines)
    {
      const std::size_t n_blanks = width - margin - display_width(line);
      line.insert(0, margin + (is_text ? 0 : n_blanks), ' ');
      line.append(is_text ? n_blanks : 0, ' ');
    }
  }

  std::vector<std::string> lines;
  std::size_t width = 0;
};

std::string side_by_side(const std::vector<const LaidOutColumn *> &columns)
{
  std::string text;
  for (std::size_t i = 0; i < columns.front()->lines.size(); ++i)
  {
    for (const LaidOutColumn *column : columns)
      text += column->lines[i];
    text.erase(text.find_last_not_of(' ') + 1);
    text += '\n';
  }
  return text;
}

std::string wrapped_lines(const std::string &text)
{
  std::istringstream lines(text);
  std::string result;
  for (std::string line; std::getline(lines, line);)
    result += (line.size() <= console_width ? line : wrapped(line)) + '\n';
  return result;
}

std::string exact(const Json &cell, const std::string &missing)
{
  if (cell.is_number_float())
    return std::isnan(cell.get<double>()) ? missing : to_text(cell.get<double>());
  if (cell.is_number_integer())
    return cell.dump();
  if (cell.is_boolean())
    return cell.get<bool>() ? "1" : "0";
  return cell.is_string() ? cell.get<std::string>() : missing;
}

} // namespace

Table as_list(const Table &row)
{
  std::vector<Column> known;
  std::copy_if(row.columns.begin(), row.columns.end(), std::back_inserter(known),
               [](const Column &column) { return !column.cells.at(0).is_null(); });
  return Fields<Column>{
    { "what", "", "",
      [](const Column &column) { return with_unit(column.quantity.heading, column.quantity.unit, false); },
      on_page(" ") },
    { "is", "", "",
      [](const Column &column) { return shown(column.quantity, column.cells.at(0), format::missing); },
      on_page(" ") }
  }.table(known, Face::page);
}

std::string console_table(const Table &table)
{
  std::size_t n_header_lines = 0;
  for (const Column &column : table.columns)
    n_header_lines = std::max(n_header_lines, header_of(column.quantity).size());
  std::vector<LaidOutColumn> columns;
  for (const Column &column : table.columns)
    columns.emplace_back(column, n_header_lines);

  std::string text = table.title.empty() ? "" : table.title + '\n';
  std::vector<const LaidOutColumn *> block = { &columns.front() };
  std::size_t width = columns.front().width;
  for (std::size_t c = 1; c < columns.size(); ++c)
  {
    if (block.size() > 1 && width + columns[c].width > console_width)
    {
      text += side_by_side(block) + '\n';
      block = { &columns.front() };
      width = columns.front().width;
    }
    block.push_back(&columns[c]);
    width += columns[c].width;
  }
  return text + side_by_side(block);
}

std::string console_text(const Results &results)
{
  std::string text;
  for (const auto &part : results.console)
    text += '\n' + (std::holds_alternative<Table>(part) ? console_table(std::get<Table>(part))
                                                        : wrapped_lines(std::get<std::string>(part)));
  return text + '\n';
}

std::string data_table(const Table &table)
{
  std::string text = "# " + table.title + '\n';
  for (std::size_t c = 0; c < table.columns.size(); ++c)
  {
    const Quantity &quantity = table.columns[c].quantity;
    text += fmt::format(FMT_STRING("# {}: {} ({})\n"), c + 1, quantity.word(Face::file), quantity.unit);
  }
  for (std::size_t row = 0; row < table.n_rows(); ++row)
    for (std::size_t c = 0; c < table.columns.size(); ++c)
      text += fmt::format(FMT_STRING("{:>24}{}"), exact(table.columns[c].cells.at(row), "nan"),
                          c + 1 < table.columns.size() ? ' ' : '\n');
  return text;
}

std::string csv_table(const Table &table)
{
  std::string text;
  const auto add = [&](std::size_t c, const std::string &field)
  { text += csv_field(field) + (c + 1 < table.columns.size() ? "," : "\r\n"); };
  for (std::size_t c = 0; c < table.columns.size(); ++c)
    add(c, with_unit(table.columns[c].quantity.word(Face::file), table.columns[c].quantity.unit));
  for (std::size_t row = 0; row < table.n_rows(); ++row)
    for (std::size_t c = 0; c < table.columns.size(); ++c)
      add(c, exact(table.columns[c].cells.at(row), ""));
  return text;
}

} // namespace stemware::pipeline
