#include "fem/pipeline/output/render/table_renderers.h"
#include "fem/pipeline/support/numbers.h"
#include "fem/pipeline/support/text.h"

#include <cmath>

namespace stemware::pipeline
{

namespace
{

/// A cell with all its digits; @p missing where there is none.
std::string exact(const Cell &cell, const std::string &missing)
{
  if (const auto *number = std::get_if<double>(&cell))
    return std::isnan(*number) ? missing : to_text(*number);
  if (const auto *count = std::get_if<std::int64_t>(&cell))
    return std::to_string(*count);
  if (const auto *flag = std::get_if<bool>(&cell))
    return *flag ? "1" : "0";
  if (const auto *text = std::get_if<std::string>(&cell))
    return *text;
  return missing;
}

} // namespace

std::string data_table(const Table &table)
{
  std::string text = "# " + table.title + '\n';
  for (std::size_t c = 0; c < table.columns.size(); ++c)
  {
    const Quantity &quantity = table.columns[c].quantity;
    text += fmt::format(FMT_STRING("# {}: {} ({})\n"), c + 1, quantity.name, quantity.unit);
  }
  for (std::size_t row = 0; row < table.n_rows(); ++row)
    for (std::size_t c = 0; c < table.columns.size(); ++c)
      text += fmt::format(FMT_STRING("{:>24}{}"), exact(table.columns[c].cells.at(row), "nan"),
                          c + 1 < table.columns.size() ? ' ' : '\n');
  return text;
}

std::string data_tables(const std::vector<Table> &tables)
{
  std::string text;
  for (const Table &table : tables)
    text += (text.empty() ? "" : "\n\n") + data_table(table);
  return text;
}

std::string csv_table(const Table &table)
{
  std::vector<std::string> header;
  for (const Column &column : table.columns)
    header.push_back(with_unit(column.quantity.name, column.quantity.unit));
  std::string text = csv_record(header);
  for (std::size_t row = 0; row < table.n_rows(); ++row)
  {
    std::vector<std::string> fields;
    for (const Column &column : table.columns)
      fields.push_back(exact(column.cells.at(row), ""));
    text += csv_record(fields);
  }
  return text;
}

} // namespace stemware::pipeline
