#include "fem/pipeline/document/quantity.h"

#include "fem/pipeline/support/shared_files.h"

#include <boost/algorithm/string/predicate.hpp>

#include <vector>

namespace stemware::pipeline
{

/// The file summary.schema.json.
const CompiledTexts &compiled_schema();

namespace
{

using Json = nlohmann::ordered_json;

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
  Json words = Json::object();
  bool is_declared = false;
  const auto declare = [&](const Json &sections, const std::string &part, const std::string &name)
  {
    if (!sections.is_object() || !sections.contains(part) || !sections[part].contains(name))
      return;
    const Json &found = sections[part][name];
    words.update(found.is_array() ? found.at(place) : found);
    is_declared = true;
  };
  declare(registry, "", key);
  declare(registry, section, key);
  declare(own, section, key);
  if (!is_declared)
  {
    const auto unit = boost::ends_with(key, ")") ? key.rfind(" (") : std::string::npos;
    for (const char *name : { "name", "heading", "label" })
      words[name] = key.substr(0, unit);
    words["unit"] = unit == std::string::npos ? "" : key.substr(unit + 2, key.size() - unit - 3);
    declare(registry, section, "*");
  }
  const Quantity usual;
  return { key,
           words.value("name", usual.name),
           words.value("unit", usual.unit),
           words.value("heading", usual.heading),
           words.value("label", usual.label),
           words.value("digits", usual.digits),
           words.value("console_digits", usual.console_digits) };
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
