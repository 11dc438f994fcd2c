#include "fem/pipeline/output/render/table.h"

#include <stdexcept>

namespace stemware::pipeline
{

Quantity Quantity::keyed(const std::string &new_key) const
{
  Quantity result = *this;
  result.key = new_key;
  return result;
}

Quantity Quantity::with_digits(std::string (*new_digits)(double)) const
{
  Quantity result = *this;
  result.digits = new_digits;
  result.console_digits = nullptr;
  return result;
}

Quantity Quantity::renamed(const std::string &new_name) const
{
  Quantity result = *this;
  result.name = new_name;
  return result;
}

Quantity Quantity::headed(const std::string &new_heading) const
{
  Quantity result = *this;
  result.heading = new_heading;
  return result;
}

Quantity Quantity::labelled(const std::string &new_label) const
{
  Quantity result = *this;
  result.label = new_label;
  return result;
}

Quantity Quantity::in_units(const std::string &new_unit) const
{
  Quantity result = *this;
  result.unit = new_unit;
  return result;
}

Table Table::with(const std::string &new_title, const std::vector<std::string> &keys) const
{
  Table view = { new_title, {} };
  for (const std::string &key : keys)
  {
    const std::size_t n_before = view.columns.size();
    for (const Column &column : columns)
      if (column.quantity.key == key)
        view.columns.push_back(column);
    if (view.columns.size() == n_before)
      throw std::out_of_range("The table has no column " + key);
  }
  return view;
}

Column numbers(const std::string &name, const std::string &unit, const std::vector<double> &values)
{
  return column({ "", name, unit, "", "" }, values);
}

Table words(const std::string &title, const std::vector<std::string> &headings,
            const std::vector<std::vector<std::string>> &rows)
{
  Table table = { title, {} };
  for (std::size_t c = 0; c < headings.size(); ++c)
    table.columns.push_back(column({ "", headings[c], "", headings[c], headings[c] }, rows,
                                   [=](const std::vector<std::string> &row) { return row.at(c); }));
  return table;
}

Table as_list(const Table &table)
{
  std::vector<std::vector<std::string>> rows;
  for (const Column &column : table.columns)
    rows.push_back(
      { with_unit(column.quantity.heading, column.quantity.unit, false), shown(column, 0, "–") });
  return words(table.title, { "", "" }, rows);
}

std::string with_unit(const std::string &name, const std::string &unit, bool ones)
{
  return unit.empty() || (unit == "1" && !ones) ? name : name + " (" + unit + ")";
}

std::string shown(const Column &column, std::size_t row, const std::string &missing, bool on_console)
{
  const Quantity &quantity = column.quantity;
  const Cell &cell = column.cells.at(row);
  if (const auto *number = std::get_if<double>(&cell); number && std::isfinite(*number))
    return (on_console && quantity.console_digits ? quantity.console_digits : quantity.digits)(
      std::abs(*number) < column.rounding ? 0 : *number);
  if (const auto *count = std::get_if<std::int64_t>(&cell))
    return std::to_string(*count);
  if (const auto *text = std::get_if<std::string>(&cell))
    return *text;
  if (const auto *flag = std::get_if<bool>(&cell))
    return *flag ? "yes" : "no";
  return missing;
}

} // namespace stemware::pipeline
