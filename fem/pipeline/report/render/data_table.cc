#include "fem/pipeline/report/render/table_renderers.h"
#include "fem/pipeline/support/numbers.h"

#include <cmath>

namespace stemware::pipeline
{

namespace
{

/// A cell with all its digits; @p missing where there is none.
std::string exact(const nlohmann::ordered_json &cell, const std::string &missing)
{
  if (cell.is_number_float())
    return std::isnan(cell.get<double>()) ? missing : to_text(cell.get<double>());
  if (cell.is_number_integer())
    return cell.dump();
  if (cell.is_boolean())
    return cell.get<bool>() ? "1" : "0";
  return cell.is_string() ? cell.get<std::string>() : missing;
}

std::string csv_field(const std::string &text)
{
  if (text.find_first_of(",\"\r\n") == std::string::npos)
    return text;
  std::string quoted = "\"";
  for (const char letter : text)
    quoted += letter == '"' ? std::string("\"\"") : std::string(1, letter);
  return quoted + '"';
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
  std::string text;
  const auto add = [&](std::size_t c, const std::string &field)
  { text += csv_field(field) + (c + 1 < table.columns.size() ? "," : "\r\n"); };
  for (std::size_t c = 0; c < table.columns.size(); ++c)
    add(c, with_unit(table.columns[c].quantity.name, table.columns[c].quantity.unit));
  for (std::size_t row = 0; row < table.n_rows(); ++row)
    for (std::size_t c = 0; c < table.columns.size(); ++c)
      add(c, exact(table.columns[c].cells.at(row), ""));
  return text;
}

} // namespace stemware::pipeline
