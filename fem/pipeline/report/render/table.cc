#include "fem/pipeline/report/render/table.h"

#include <sstream>
#include <stdexcept>

namespace stemware::pipeline
{

Table Table::with(const std::string &new_title, const std::string &keys) const
{
  Table view = { new_title, {} };
  std::istringstream words(keys);
  for (std::string key; words >> key;)
  {
    const std::size_t n_before = view.columns.size();
    for (const Column &column : columns)
      if (column.quantity.key == key)
        view.columns.push_back(column);
    if (view.columns.size() == n_before)
      throw std::out_of_range("the table has no column " + key);
  }
  return view;
}

Quantity &Table::operator[](const std::string &key)
{
  for (Column &column : columns)
    if (column.quantity.key == key)
      return column.quantity;
  throw std::out_of_range("the table has no column " + key);
}

Column numbers(const std::string &name, const std::string &unit, const std::vector<double> &values)
{
  return column(Quantity("", name, unit), values);
}

Table number_rows(const std::string &title, const std::vector<std::pair<std::string, std::string>> &columns,
                  const std::vector<std::vector<double>> &rows)
{
  Table table = { title, {} };
  for (std::size_t c = 0; c < columns.size(); ++c)
    table.columns.push_back(column(Quantity("", columns[c].first, columns[c].second), rows,
                                   [=](const std::vector<double> &row) { return row.at(c); }));
  return table;
}

Table words(const std::string &title, const std::vector<std::string> &headings,
            const std::vector<std::vector<std::string>> &rows)
{
  Table table = { title, {} };
  for (std::size_t c = 0; c < headings.size(); ++c)
    table.columns.push_back(column(Quantity("", headings[c], "", headings[c], headings[c]), rows,
                                   [=](const std::vector<std::string> &row) { return row.at(c); }));
  return table;
}

Table as_list(const Table &table)
{
  std::vector<std::vector<std::string>> rows;
  for (const Column &column : table.columns)
    rows.push_back({ heading_with_unit(column.quantity), shown(column, 0, "–") });
  return words(table.title, { "", "" }, rows);
}

std::string with_unit(const std::string &name, const std::string &unit, bool ones)
{
  return unit.empty() || (unit == "1" && !ones) ? name : name + " (" + unit + ")";
}

std::string heading_with_unit(const Quantity &quantity)
{
  return with_unit(quantity.heading, quantity.unit, false);
}

std::string shown(const Column &column, std::size_t row, const std::string &missing, bool on_console)
{
  const Quantity &quantity = column.quantity;
  const Cell &cell = column.cells.at(row);
  if (const auto *number = std::get_if<double>(&cell); number && std::isfinite(*number))
  {
    if (column.uncertainty > 0 && std::abs(*number) >= column.rounding)
      return format::to_spread(*number, column.uncertainty);
    return (on_console && quantity.console_digits ? quantity.console_digits : quantity.digits)(
      std::abs(*number) < column.rounding ? 0 : *number);
  }
  if (const auto *count = std::get_if<std::int64_t>(&cell))
    return std::to_string(*count);
  if (const auto *text = std::get_if<std::string>(&cell))
    return *text;
  if (const auto *flag = std::get_if<bool>(&cell))
    return *flag ? "yes" : "no";
  return missing;
}

} // namespace stemware::pipeline
