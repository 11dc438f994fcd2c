#include "fem/pipeline/document/quantity.h"

#include "fem/pipeline/support/shared_files.h"

#include <boost/algorithm/string/predicate.hpp>

#include <array>
#include <vector>

namespace stemware::pipeline
{

/// The file summary.schema.json.
const CompiledTexts &compiled_schema();

namespace
{

using Json = nlohmann::ordered_json;

/// The words of a declaration that say how tables show the quantity.
constexpr std::array members = {
  std::pair("name", &Quantity::name),   std::pair("heading", &Quantity::heading),
  std::pair("label", &Quantity::label), std::pair("digits", &Quantity::digits),
  std::pair("unit", &Quantity::unit),   std::pair("console_digits", &Quantity::console_digits)
};

const Json &schema()
{
  static const Json schema = Json::parse(text_of(compiled_schema(), "summary.schema.json"));
  return schema;
}

/// The declarations of the values of an object; none of what is no object.
const Json &properties_of(const Json &declaration)
{
  static const Json nothing = Json::object();
  return declaration.contains("properties") ? declaration["properties"] : nothing;
}

/// Quantities by section and key: those of the properties of a part of the schema in the sections of all
/// parts that they stand in, and in "", which all tables share, unless that has the key.
class Registry
{
public:
  Registry()
  {
    const Json &definitions = schema()["definitions"];
    add_properties(definitions["columns"], { "" });
    for (const auto &[table, part] : definitions["tables"]["properties"].items())
      add_properties(part, { table });
    add_properties(schema(), { "" });
  }

  Json quantities = Json::object();

private:
  void add_properties(const Json &part, const std::vector<std::string> &sections)
  {
    for (const auto &[key, value] : properties_of(part).items())
    {
      add(key, value, sections);
      std::vector<std::string> inner = sections;
      inner.push_back(key);
      add_properties(value, inner);
      for (const char *each : { "items", "additionalProperties" })
        if (value.contains(each) && value[each].is_object())
          add_properties(value[each], inner);
    }
  }

  void add(const std::string &key, Json value, const std::vector<std::string> &sections)
  {
    const bool is_list = value.contains("items") && value["items"].is_array();
    const bool is_shown = value.contains("name") || value.contains("heading") || value.contains("label");
    if (value.contains("description") && !is_list && !is_shown)
      return;
    if (const Json type = value.value("type", Json()); type == "string" || type == Json{ "string", "null" })
      value.emplace("unit", ""); // words have none
    Json places = Json::array();
    if (is_list)
      for (const Json &item : value["items"])
      {
        places.push_back(value);
        places.back().update(item);
      }
    for (const std::string &section : sections)
      quantities[section].emplace(key + (is_list ? list_mark : ""), Json(is_list ? places : value));
  }
};

/// The declaration of @p key among the quantities of a section; of a list the one of that place.
void declare(const Json &quantities, const std::string &key, std::size_t place, Quantity &quantity)
{
  if (!quantities.is_object() || !quantities.contains(key))
    return;
  const Json &found = quantities[key], &declared = found.is_array() ? found.at(place) : found;
  for (const auto &[word, member] : members)
    quantity.*member = declared.value(word, quantity.*member);
}

/// The listed ones of @p part, which @p declaration declares.
Json listed_of(const Json &part, const Json &declaration)
{
  Json list = Json::object();
  for (const auto &[key, value] : properties_of(declaration).items())
    if (!part.contains(key))
      continue;
    else if (value.value("listed", false))
      list[key] = part[key];
    else if (part[key].is_object())
      list.update(listed_of(part[key], value));
  return list;
}

} // namespace

Quantity quantity_named(const std::string &key, const std::string &section, std::size_t place,
                        const Json &own)
{
  static const Json registry = Registry().quantities;
  const Json in_section = registry.value(section, Json()),
             of_document = own.is_null() ? Json() : own.value(section, Json());
  const auto has = [&](const Json &quantities) { return quantities.is_object() && quantities.contains(key); };
  Quantity result = { key };
  if (!has(registry[""]) && !has(in_section) && !has(of_document))
  {
    const auto unit = boost::ends_with(key, ")") ? key.rfind(" (") : std::string::npos;
    result.name = result.heading = result.label = key.substr(0, unit);
    result.unit = unit == std::string::npos ? "" : key.substr(unit + 2, key.size() - unit - 3);
    declare(in_section, "*", place, result);
  }
  for (const Json *quantities : { static_cast<const Json *>(&registry[""]), &in_section, &of_document })
    declare(*quantities, key, place, result);
  return result;
}

Json declared(const Json &values, const std::string &name)
{
  const Json &part = properties_of(schema()).at(name);
  Json result = Json::array();
  for (const Json &row : values.is_array() ? values : Json::array({ values }))
  {
    result.push_back(Json::object());
    for (const auto &[key, value] : properties_of(values.is_array() ? part["items"] : part).items())
      if (row.contains(key))
        result.back()[key] = row[key];
  }
  return values.is_array() ? result : result[0];
}

Json listed(const Json &part, const std::string &name)
{
  const Json &parts = properties_of(schema());
  return parts.contains(name) ? listed_of(part, parts[name]) : Json::object();
}

std::string with_unit(const std::string &name, const std::string &unit, bool ones)
{
  return unit.empty() || (unit == "1" && !ones) ? name : name + " (" + unit + ")";
}

std::string heading_with_unit(const Quantity &quantity)
{
  return with_unit(quantity.heading, quantity.unit, false);
}

} // namespace stemware::pipeline
