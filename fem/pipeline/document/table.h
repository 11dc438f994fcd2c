#pragma once

#include "fem/pipeline/document/number_format.h"
#include "fem/pipeline/support/json.h"

#include <nlohmann/json.hpp>

#include <string>
#include <utility>
#include <vector>

/// The quantities of summary.json and of all tables, as summary.schema.json declares them: a key, its type,
/// unit and one sentence there are JSON Schema's; "name", "heading", "label", "digits" and "console_digits"
/// beside them are those of a Quantity, and "listed" marks a Quantity for the list of its part of the
/// summary.
namespace stemware::pipeline
{

/// Suffix of the key of a list: one column for each of its numbers.
inline constexpr char list_mark[] = "[]";

/// Column without its values: key, names, unit, digits. A quantity without a name is not shown.
struct Quantity
{
  std::string key = "";            ///< key in summary.json and of the column
  std::string name = "";           ///< in data files, without its unit: "terminal omega"
  std::string unit = "1";          ///< SI; "1" for pure numbers, empty for words
  std::string heading = "";        ///< in reports, without its unit: "terminal spin"
  std::string label = "";          ///< on the console, without its unit; maybe in lines: "change\nof spin"
  std::string digits = ".6g";      ///< displayed digits, argument of format::number()
  std::string console_digits = ""; ///< for the console, if different
};

/// Returns the quantity declared by the schema as @p key. Searched in this order: declarations @p own of a
/// document, the part of the summary or table @p section, columns of all tables, first occurrence in the
/// summary. An undeclared key is the name of the column, "name (unit)"; without a unit it has words. @p place
/// distinguishes the entries of a list, "torque[]".
Quantity quantity_named(const std::string &key, const std::string &section = "", std::size_t place = 0,
                        const nlohmann::ordered_json &own = nullptr);

/// Returns the part @p name of the summary from @p values, an object or a list of objects: the declared keys
/// that exist in @p values, in the order of the schema.
nlohmann::ordered_json declared(const nlohmann::ordered_json &values, const std::string &name);

/// Returns the values of @p part, the part @p name of the summary, that the schema marks as "listed", in its
/// order, nested parts included.
nlohmann::ordered_json listed(const nlohmann::ordered_json &part, const std::string &name);

/// Returns "name (unit)", or the name only if the unit is empty, or 1 and @p ones is false.
std::string with_unit(const std::string &name, const std::string &unit, bool ones = true);

/// Returns the heading of a quantity in reports, with its unit unless that is 1.
std::string heading_with_unit(const Quantity &quantity);

/// Quantity with its values; missing values are null: nan in data files, empty in CSV, a dash in reports.
struct Column
{
  Quantity quantity;
  std::vector<nlohmann::ordered_json> cells;
};

/// Columns of equal length under a title. Renderers (table_renderers.h) show all columns in this order.
struct Table
{
  std::string title;
  std::vector<Column> columns;

  std::size_t n_rows() const { return columns.empty() ? 0 : columns.front().cells.size(); }
};

/// Returns the table of a list of objects, or of one object as its only row: one column for each of @p keys
/// (separated by blanks; default: keys of the first object, lists with []). A key with [] gives one column
/// for each number of a list, "torque[]". Columns are named by quantity_named(). Throws std::out_of_range for
/// a key that no row has.
Table table_of(const nlohmann::ordered_json &rows, const std::string &keys = "",
               const std::string &section = "", const std::string &title = "",
               const nlohmann::ordered_json &own = nullptr);

/// Returns a column of numbers for data files only.
Column numbers(const std::string &name, const std::string &unit, const std::vector<double> &values);

/// Returns a column of numbers for data files only, one from each of @p rows: @p value is a member, or is
/// called with the row.
template <typename Rows, typename Value>
Column numbers(const std::string &name, const std::string &unit, const Rows &rows, Value value)
{
  Column column = { { "", name, unit }, {} };
  for (const auto &row : rows)
    column.cells.push_back(std::invoke(value, row));
  return column;
}

/// Returns a table of numbers for data files only, from rows; @p columns are names and units.
Table number_rows(const std::string &title, const std::vector<std::pair<std::string, std::string>> &columns,
                  const std::vector<std::vector<double>> &rows);

/// Returns the object @p json, or each object of a list, reduced to @p keys (separated by blanks), in their
/// order. Throws nlohmann::json::out_of_range for a missing key.
nlohmann::ordered_json selected_keys(const nlohmann::ordered_json &json, const std::string &keys);

/// Returns a table of one row as a list of objects with "what" (name and unit) and "is" (value).
nlohmann::ordered_json name_value_list(const Table &table);

/// Returns a cell as text for console or report; @p missing for a missing value.
std::string shown(const Column &column, std::size_t row, const std::string &missing, bool on_console = false);

/// Sets values below @p rounding to 0 for @p keys (separated by blanks) in each of @p rows, for display; data
/// files keep them.
void zero_rounding_errors(nlohmann::ordered_json &rows, const std::string &keys, double rounding);

} // namespace stemware::pipeline
