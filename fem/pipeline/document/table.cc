#include "fem/pipeline/document/table.h"

#include <boost/algorithm/string/erase.hpp>
#include <boost/algorithm/string/split.hpp>
#include <boost/algorithm/string/trim.hpp>

#include <algorithm>
#include <stdexcept>

namespace stemware::pipeline
{

namespace
{

using Json = nlohmann::ordered_json;

std::vector<std::string> words_of(const std::string &text)
{
  std::vector<std::string> words;
  const std::string trimmed = boost::trim_copy(text);
  if (!trimmed.empty())
    boost::split(
      words, trimmed, [](char c) { return c == ' '; }, boost::token_compress_on);
  return words;
}

/// The value of @p key in a row; of a list that of @p place.
Json cell_of(const Json &row, const std::string &key, std::size_t place)
{
  const std::string name = boost::erase_last_copy(key, list_mark);
  if (!row.contains(name))
    return nullptr;
  return name == key ? row[name] : row[name].at(place);
}

} // namespace

Json picked(const Json &json, const std::string &keys)
{
  Json result = json.is_array() ? Json::array() : Json::object();
  if (json.is_array())
    for (const Json &row : json)
      result.push_back(picked(row, keys));
  else
    for (const std::string &key : words_of(keys))
      result[key] = json.at(key);
  return result;
}

Table table_of(const Json &data, const std::string &keys, const std::string &section,
               const std::string &title, const Json &own)
{
  const Json single = data.is_array() ? Json() : Json::array({ data });
  const Json &rows = data.is_array() ? data : single;
  std::vector<std::string> names = words_of(keys);
  if (names.empty() && !rows.empty())
    for (const auto &[key, value] : rows[0].items())
      names.push_back(key + (value.is_array() ? list_mark : ""));
  Table table = { title, {} };
  for (const std::string &key : names)
  {
    const std::string name = boost::erase_last_copy(key, list_mark);
    const auto has = [&](const Json &row) { return row.contains(name); };
    if (!rows.empty() && std::none_of(rows.begin(), rows.end(), has))
      throw std::out_of_range("the table has no column " + key);
    const std::size_t n_places = name == key ? 1 : (rows.empty() ? 0 : rows[0].at(name).size());
    for (std::size_t place = 0; place < n_places; ++place)
    {
      Column column = { quantity_named(key, section, place, own), {} };
      for (const Json &row : rows)
        column.cells.push_back(cell_of(row, key, place));
      table.columns.push_back(column);
    }
  }
  return table;
}

Column numbers(const std::string &name, const std::string &unit, const std::vector<double> &values)
{
  return { { "", name, unit }, { values.begin(), values.end() } };
}

Table number_rows(const std::string &title, const std::vector<std::pair<std::string, std::string>> &columns,
                  const std::vector<std::vector<double>> &rows)
{
  Table table = { title, {} };
  for (std::size_t c = 0; c < columns.size(); ++c)
    table.columns.push_back(numbers(columns[c].first, columns[c].second, rows,
                                    [=](const std::vector<double> &row) { return row.at(c); }));
  return table;
}

Json as_list(const Table &table)
{
  Json list = Json::array();
  for (const Column &column : table.columns)
    list.push_back(
      { { "what", heading_with_unit(column.quantity) }, { "is", shown(column, 0, format::missing) } });
  return list;
}

std::string shown(const Column &column, std::size_t row, const std::string &missing, bool on_console)
{
  const Quantity &quantity = column.quantity;
  const Json &cell = column.cells.at(row);
  if (cell.is_number_float() && std::isfinite(cell.get<double>()))
    return format::number(cell, on_console && !quantity.console_digits.empty() ? quantity.console_digits
                                                                               : quantity.digits);
  if (cell.is_number_integer())
    return cell.dump();
  if (cell.is_string())
    return cell;
  if (cell.is_boolean())
    return cell.get<bool>() ? "yes" : "no";
  return missing;
}

void leave_out_rounding(Json &rows, const std::string &keys, double rounding)
{
  const auto leave_out = [=](Json &value)
  {
    if (value.is_number_float() && std::abs(value.get<double>()) < rounding)
      value = 0.;
  };
  for (const std::string &key : words_of(keys))
    for (Json &row : rows)
      if (Json &value = row.at(key); value.is_array())
        std::for_each(value.begin(), value.end(), leave_out);
      else
        leave_out(value);
}

} // namespace stemware::pipeline
