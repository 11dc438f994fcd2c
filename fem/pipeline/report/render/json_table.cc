#include "fem/pipeline/report/render/table_renderers.h"

#include <boost/algorithm/string/predicate.hpp>

namespace stemware::pipeline
{

namespace
{

using Json = nlohmann::ordered_json;

Json json_cell(const Cell &cell)
{
  return std::visit(
    [](const auto &value)
    {
      using Value = std::decay_t<decltype(value)>;
      if constexpr (std::is_same_v<Value, std::monostate>)
        return Json(nullptr);
      else
        return Json(value);
    },
    cell);
}

} // namespace

Json json_row(const Table &table, std::size_t row)
{
  const std::string list = "[]";
  Json object = Json::object();
  for (const Column &column : table.columns)
  {
    const std::string &key = column.quantity.key;
    const Json value = json_cell(column.cells.at(row));
    if (boost::ends_with(key, list))
      object[key.substr(0, key.size() - list.size())].push_back(value);
    else if (!key.empty())
      object[key] = value;
  }
  return object;
}

Json json_table(const Table &table)
{
  Json rows = Json::array();
  for (std::size_t row = 0; row < table.n_rows(); ++row)
    rows.push_back(json_row(table, row));
  return rows;
}

Json json_by_name(const Table &table)
{
  Table rest = table;
  rest.columns.erase(rest.columns.begin());
  Json objects = Json::object();
  for (std::size_t row = 0; row < table.n_rows(); ++row)
    objects[std::get<std::string>(table.columns.front().cells.at(row))] = json_row(rest, row);
  return objects;
}

Json json_number(const std::optional<double> &value)
{
  return value ? Json(*value) : Json(nullptr);
}

} // namespace stemware::pipeline
