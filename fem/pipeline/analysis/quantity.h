#pragma once

#include "fem/pipeline/base/json.h"

#include <array>
#include <cstddef>
#include <functional>
#include <initializer_list>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

/// Quantities of the results. Each is declared once, in a list of Fields, with key, unit, words and the
/// function that reads it from a row. The list gives summary.json, its schema, data files and tables.
namespace stemware::pipeline
{

/// Faces of a table.
enum class Face
{
  file,    ///< CSV and data files
  page,    ///< tables of the page
  console, ///< tables of the console
  picture, ///< numbers of the page's pictures
  python   ///< arrays of the Python package
};

/// Key, unit and words of a quantity. A face for which the word is empty does not show the quantity.
struct Quantity
{
  std::string key = "";         ///< key in summary.json, tables and the list of columns
  std::string unit = "1";       ///< SI; "1" for pure numbers, empty for words
  std::string description = ""; ///< one sentence; empty: not in summary.json
  std::string name = "";        ///< heading in data files, without its unit
  std::string column = "";      ///< description of that column
  std::string heading = "";     ///< heading on the page, without its unit
  /// Label on the console, without its unit; may have line ends: "change\nof spin".
  std::string label = "";
  std::string digits = ".6g";        ///< displayed digits, argument of format::number()
  Json type = {};                    ///< JSON Schema of the values
  bool may_be_absent = false;        ///< no key in summary.json instead of null
  std::vector<Quantity> places = {}; ///< columns of a list of fixed length
  std::string number = "";           ///< replaces a * in the words, which stands for any number
  std::string drawn = "";            ///< key in pictures
  std::string array = "";            ///< key in Python
  std::string banded = "";           ///< name in tables of error bands; empty: no band is estimated

  /// Returns the word of a face; empty if the quantity is not shown.
  std::string word(Face face) const;
};

/// Returns "name (unit)", or the name only if the unit is empty, or 1 and @p shows_one is false.
std::string with_unit(const std::string &name, const std::string &unit, bool shows_one = true);

/// Quantity with its values; null (missing) is nan in data files, empty in CSV, a dash elsewhere.
struct Column
{
  Quantity quantity;
  std::vector<Json> cells = {};
};

/// Columns of equal length under a title, shown in this order by all renderers (result/results.h).
struct Table
{
  std::string title = {};
  std::vector<Column> columns = {};

  std::size_t n_rows() const { return columns.empty() ? 0 : columns.front().cells.size(); }
};

// ---- words of a quantity, arguments of Field: in_column("spin"), on_page("spin"), in_picture("omega"),
// in_python("omega"), with_digits("+.3g"), ...

using Word = std::function<void(Quantity &)>;

/// Declares @p member of a quantity.
template <auto member, typename Value = std::decay_t<decltype(std::declval<Quantity &>().*member)>>
Word word_of(const Value &value)
{
  return [value](Quantity &quantity) { quantity.*member = value; };
}

/// Declares the description of a column of data files whose heading is the key.
inline constexpr auto &in_column = word_of<&Quantity::column>;
/// Declares the heading on the page.
inline constexpr auto &on_page = word_of<&Quantity::heading>;
/// Declares the label on the console.
inline constexpr auto &on_console = word_of<&Quantity::label>;
/// Declares the format of digits on page and console.
inline constexpr auto &with_digits = word_of<&Quantity::digits>;
/// Declares the key in pictures.
inline constexpr auto &in_picture = word_of<&Quantity::drawn>;
/// Declares the key in Python.
inline constexpr auto &in_python = word_of<&Quantity::array>;
/// Declares the columns of a list of fixed length.
inline constexpr auto &with_places = word_of<&Quantity::places>;
/// Declares the number in place of a * in the words.
inline constexpr auto &with_number = word_of<&Quantity::number>;
/// Declares heading and description of a column of data files.
inline Word in_file(const std::string &name, const std::string &column)
{
  return [=](Quantity &quantity) { quantity.name = name, quantity.column = column; };
}
/// Declares heading on the page and label on the console, which are equal.
inline Word shown_as(const std::string &word)
{
  return [=](Quantity &quantity) { quantity.heading = quantity.label = word; };
}
/// Declares the name of a quantity with an error band; empty: the description of its column, declared before.
inline Word in_bands(const std::string &name = "")
{
  return [=](Quantity &quantity) { quantity.banded = name.empty() ? quantity.column : name; };
}
/// Declares the JSON Schema of the values, in addition to the schema of their type.
inline Word of_type(const Json &type)
{
  return [=](Quantity &quantity) { quantity.type.update(type); };
}
/// Declares that a missing value has no key in summary.json, instead of null.
inline constexpr auto or_absent = [] { return word_of<&Quantity::may_be_absent>(true); };

// ---- C++ types

/// Returns the JSON Schema @p type with null as a further value.
Json or_null(Json type);

/// Length of a list type; 0: any length, -1: no list.
template <typename Value>
inline constexpr int length_of = -1;
template <typename Value>
inline constexpr int length_of<std::vector<Value>> = 0;
template <typename Value, std::size_t n>
inline constexpr int length_of<std::array<Value, n>> = n;

/// Returns the JSON Schema of a C++ type: number, text or list; for an optional or a pointer, also null;
/// @p part for other types.
template <typename Value>
Json schema_of(const Json &part = Json::object())
{
  if constexpr (std::is_same_v<Value, Json>)
    return part;
  else if constexpr (std::is_convertible_v<Value, std::string>)
    return { { "type", "string" } };
  else if constexpr (std::is_arithmetic_v<Value>)
    return { { "type", std::is_same_v<Value, bool>       ? "boolean"
                       : std::is_floating_point_v<Value> ? "number"
                                                         : "integer" } };
  else if constexpr (std::is_constructible_v<bool, Value>) // an optional or a pointer
    return or_null(schema_of<std::decay_t<decltype(*std::declval<Value>())>>(part));
  else if constexpr (constexpr int length = length_of<Value>; length >= 0)
  {
    Json type = { { "type", "array" }, { "items", schema_of<typename Value::value_type>(part) } };
    if (length > 0)
      type.update({ { "minItems", length }, { "maxItems", length } });
    return type;
  }
  else
  {
    static_assert(std::is_class_v<Value>);
    return part;
  }
}

/// Returns the JSON Schema of an object with the members @p quantities.
Json schema_of_object(const std::vector<Quantity> &quantities);

/// Adds the column of @p quantity to @p columns, or one for each of its places.
void add_columns(const Quantity &quantity, const std::vector<Json> &cells, Face face,
                 std::vector<Column> &columns);

template <typename Row>
class Fields;

/// Quantity with the function that reads it from a Row.
template <typename Row>
struct Field
{
  Quantity quantity;
  std::function<Json(const Row &)> value;

  /// Creates a quantity (for tables only if @p description is empty). @p read: member or function of a row.
  template <typename Read, typename... Words,
            typename = std::enable_if_t<std::is_invocable_v<Read, const Row &>>>
  Field(const std::string &key, const std::string &unit, const std::string &description, Read read,
        Words... words)
      : value([read](const Row &row) { return Json(std::invoke(read, row)); })
  {
    using Value = std::decay_t<std::invoke_result_t<Read, const Row &>>;
    const Json type = schema_of<Value>();
    quantity = { key, type.value("type", Json()) == "string" ? "" : unit, description };
    quantity.type = type;
    (words(quantity), ...);
  }

  /// Creates a field whose value is a JSON object: @p fields of the result of @p read. If this result is a
  /// vector, the value is a list of objects, or with Fields::by() an object of objects; if it is an optional
  /// or a pointer without value, null.
  template <typename Part, typename Read, typename... Words>
  Field(const std::string &key, const std::string &description, const Fields<Part> &fields, Read read,
        Words... words)
  {
    using Found = std::decay_t<std::invoke_result_t<Read, const Row &>>;
    value = [read, fields](const Row &row) -> Json
    {
      const auto &found = std::invoke(read, row);
      if constexpr (std::is_constructible_v<bool, Found>) // an optional or a pointer
        return found ? fields.json(*found) : Json(nullptr);
      else
        return fields.json(found);
    };
    quantity = { key, "", description };
    quantity.type = schema_of<Found>(fields.schema());
    if (fields.is_keyed())
    {
      const bool is_optional = quantity.type["type"].is_array();
      quantity.type = { { "type", "object" }, { "additionalProperties", fields.schema() } };
      if (is_optional)
        quantity.type = or_null(quantity.type);
    }
    (words(quantity), ...);
  }
};

/// List of quantities that are read from a Row.
template <typename Row>
class Fields
{
public:
  Fields(std::initializer_list<Field<Row>> fields = {})
      : members(fields)
  {
  }

  /// Returns @p fields of the result of @p read, followed by this list.
  template <typename Part, typename Read>
  Fields include(const Fields<Part> &fields, Read read) const
  {
    Fields all;
    for (const Field<Part> &field : fields.all())
    {
      Field<Row> &added = all.members.emplace_back(
        "", "", "", [read, value = field.value](const Row &row) { return value(std::invoke(read, row)); });
      added.quantity = field.quantity;
    }
    all.members.insert(all.members.end(), members.begin(), members.end());
    return all;
  }

  /// Returns this list for rows that become members of an object under the key that @p key returns.
  Fields by(std::function<std::string(const Row &)> key) const
  {
    Fields keyed = *this;
    keyed.key_of = std::move(key);
    return keyed;
  }

  void add(const Field<Row> &field) { members.push_back(field); }
  const std::vector<Field<Row>> &all() const { return members; }

  /// Returns the JSON Schema of json() of a row.
  Json schema() const
  {
    std::vector<Quantity> quantities;
    for (const Field<Row> &field : members)
      quantities.push_back(field.quantity);
    return schema_of_object(quantities);
  }

  /// Returns the quantities that have a description, by key.
  Json json(const Row &row) const
  {
    Json object = Json::object();
    for (const auto &[quantity, value] : members)
      if (!quantity.description.empty())
        if (Json found = value(row); !found.is_null() || !quantity.may_be_absent)
          object[quantity.key] = std::move(found);
    return object;
  }
  /// Returns the list of the rows, or the object by key.
  Json json(const std::vector<Row> &rows) const
  {
    Json all = key_of ? Json::object() : Json::array();
    for (const Row &row : rows)
      (key_of ? all[key_of(row)] : all.emplace_back()) = json(row);
    return all;
  }

  /// Returns the table of @p rows for a face.
  Table table(const std::vector<Row> &rows, Face face, const std::string &title = "") const
  {
    Table table = { title };
    for (const auto &[quantity, value] : members)
      if (!quantity.word(face).empty() || !quantity.places.empty())
      {
        std::vector<Json> cells;
        for (const Row &row : rows)
          cells.push_back(value(row));
        add_columns(quantity, cells, face, table.columns);
      }
    return table;
  }

  /// Returns true if rows become members of an object, by().
  bool is_keyed() const { return static_cast<bool>(key_of); }

private:
  std::vector<Field<Row>> members;
  std::function<std::string(const Row &)> key_of = {};
};

} // namespace stemware::pipeline
