#include "fem/pipeline/analysis/quantity.h"

#include <boost/algorithm/string/replace.hpp>

namespace stemware::pipeline
{

std::string with_unit(const std::string &name, const std::string &unit, bool shows_one)
{
  return unit.empty() || (unit == "1" && !shows_one) ? name : name + " (" + unit + ")";
}

std::string Quantity::word(Face face) const
{
  const std::string &pattern = face == Face::file      ? name
                               : face == Face::page    ? heading
                               : face == Face::console ? label
                               : face == Face::picture ? drawn
                                                       : array;
  return boost::replace_all_copy(pattern, "*", number);
}

Json or_null(Json type)
{
  if (type.contains("type"))
    type["type"] = { type["type"], "null" };
  return type;
}

Json schema_of_object(const std::vector<Quantity> &quantities)
{
  Json properties = Json::object(), required = Json::array();
  for (const Quantity &quantity : quantities)
  {
    if (quantity.description.empty())
      continue;
    Json property = { { "description", quantity.description } };
    if (!quantity.unit.empty() && quantity.unit != "1")
      property["unit"] = quantity.unit;
    property.update(quantity.type);
    properties[quantity.key] = property;
    if (!quantity.may_be_absent)
      required.push_back(quantity.key);
  }
  return { { "type", "object" },
           { "properties", properties },
           { "required", required },
           { "additionalProperties", false } };
}

void add_columns(const Quantity &quantity, const std::vector<Json> &cells, Face face,
                 std::vector<Column> &columns)
{
  if (quantity.places.empty())
    columns.push_back({ quantity, cells });
  for (std::size_t place = 0; place < quantity.places.size(); ++place)
    if (!quantity.places[place].word(face).empty())
    {
      Column &column = columns.emplace_back(Column{ quantity.places[place] });
      for (const Json &cell : cells)
        column.cells.push_back(cell.is_null() ? cell : cell.at(place));
    }
}

} // namespace stemware::pipeline
