#include "fem/pipeline/document/table.h"

#include "fem/pipeline/system/shared_files.h"

#include <boost/algorithm/string/erase.hpp>
#include <boost/algorithm/string/predicate.hpp>
#include <boost/algorithm/string/replace.hpp>
#include <boost/algorithm/string/split.hpp>
#include <boost/algorithm/string/trim.hpp>

#include <algorithm>
#include <stdexcept>

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
    for (const auto &[file, columns] : definitions["files"].items())
      if (columns.is_object())
        for (const auto &[key, column] : columns.items())
          add(key,
              { { "unit", column["unit"] }, { "label", column["label"] }, { "heading", column["label"] } },
              { file });
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
  if (!is_declared) // one of a family: "a*" for "a12"
  {
    const std::size_t end = key.find_last_not_of("0123456789") + 1;
    if (end > 0 && end < key.size())
      declare(registry, section, key.substr(0, end) + '*');
    for (const char *text : { "name", "heading", "label" })
      if (words.contains(text))
        words[text] = boost::replace_all_copy(words[text].get<std::string>(), "*", key.substr(end));
  }
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
           words.value("heading", words.value("label", usual.heading)),
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

Json selected_keys(const Json &json, const std::string &keys)
{
  Json result = json.is_array() ? Json::array() : Json::object();
  if (json.is_array())
    for (const Json &row : json)
      result.push_back(selected_keys(row, keys));
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

Json name_value_list(const Table &table)
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

void zero_rounding_errors(Json &rows, const std::string &keys, double rounding)
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
