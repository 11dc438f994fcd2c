#include "fem/pipeline/document/document.h"

#include <map>

namespace stemware::pipeline
{

using Json = nlohmann::ordered_json;

namespace
{

/// Digits of numbers that a table shows.
constexpr int n_table_digits = 10;

Json shortened_cell(const Json &cell)
{
  return cell.is_number_float() ? shortened(cell.get<double>(), n_table_digits) : cell;
}

} // namespace

void Document::add_rows(const std::string &name, const Json &rows, const std::string &keys,
                        const std::string &section)
{
  const Table table = table_of(rows, keys, section.empty() ? name : section);
  Json &shown = tables[name] = { { "keys", Json::array() }, { "values", Json::array() } };
  std::map<std::string, std::size_t> n_of_key;
  for (const Column &column : table.columns)
  {
    const Quantity &quantity = column.quantity;
    const std::size_t place = n_of_key[quantity.key]++;
    const bool is_list = quantity.key.size() > 2 && quantity.key.substr(quantity.key.size() - 2) == list_mark;
    const std::string key =
      is_list ? quantity.key.substr(0, quantity.key.size() - 1) + std::to_string(place) + "]" : quantity.key;
    shown["keys"].push_back(key);
    Json &values = shown["values"].emplace_back(Json::array());
    for (const Json &cell : column.cells)
      values.push_back(shortened_cell(cell));
    quantities[name][key] = { { "heading", quantity.heading },
                              { "unit", quantity.unit },
                              { "digits", quantity.digits } };
  }
}

void Document::add_list(const std::string &name)
{
  const Table numbers = table_of(listed(findings.summary.at(name), name), "", name);
  if (numbers.n_rows() > 0)
    add_rows(name, name_value_list(numbers));
}

} // namespace stemware::pipeline
