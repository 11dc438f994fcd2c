#pragma once

#include "fem/pipeline/document/json.h"
#include "fem/pipeline/document/number_format.h"

#include <nlohmann/json.hpp>

#include <string>
#include <utility>
#include <vector>

/// The quantities of summary.json and of all tables, as summary.schema.json declares them: a key, its type,
/// unit and one sentence there are JSON Schema's; "name", "heading", "label", "digits" and "console_digits"
/// beside them are those of a Quantity, and "listed" has it stand in lists of the part that it belongs to.
namespace stemware::pipeline
{

/// Suffix of the key of a list: one column for each of its numbers.
inline constexpr char list_mark[] = "[]";

/// Everything about a column but its values: where and how it is named, its unit, its digits. Where it has no
/// name, it is not shown.
struct Quantity
{
  std::string key = "";            ///< in summary.json, and what the column is found by
  std::string name = "";           ///< in data files, without its unit: "terminal omega"
  std::string unit = "1";          ///< SI; "1" for pure numbers, empty for words
  std::string heading = "";        ///< in reports, without its unit: "terminal spin"
  std::string label = "";          ///< on the console, without its unit; maybe in lines: "change\nof spin"
  std::string digits = ".6g";      ///< for people, as format::number() takes them
  std::string console_digits = ""; ///< on the console, where those differ
};

/// The quantity that the schema declares as @p key: in the part of the summary or the table @p section where
/// that has one of its own, else among the columns of all tables, else where the summary has the key first.
/// The declarations @p own of a document come before those. One that nobody declares is a column that is
/// named by its key, "name (unit)"; without a unit it has words. The places of a list, "torque[]", are told
/// apart by
/// @p place.
Quantity quantity_named(const std::string &key, const std::string &section = "", std::size_t place = 0,
                        const nlohmann::ordered_json &own = nullptr);

/// The part @p name of the summary, made of @p values, an object or a list of objects: those of its keys that
/// the values have, in the order of the schema.
nlohmann::ordered_json declared(const nlohmann::ordered_json &values, const std::string &name);

/// The values of the part @p name of the summary, @p part, that the schema calls "listed", in its order;
/// those of parts in it among them.
nlohmann::ordered_json listed(const nlohmann::ordered_json &part, const std::string &name);

/// "name (unit)"; the name alone where there is no unit, or the unit is 1 and @p ones is false.
std::string with_unit(const std::string &name, const std::string &unit, bool ones = true);

/// Heading of a quantity in reports, with its unit unless that is 1.
std::string heading_with_unit(const Quantity &quantity);

/// A quantity with its values; null where one does not exist: nan in data files, empty in CSV, a dash for
/// people.
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

/// The table of a list of objects, or of a single one as its only row: a column for each of @p keys (parted
/// by blanks), by default those of the first object, lists with []. A key with [] stands for all numbers of a
/// list, a column for each: "torque[]". Columns are named as quantity_named() says. Throws std::out_of_range
/// for a key that no row has.
Table table_of(const nlohmann::ordered_json &rows, const std::string &keys = "",
               const std::string &section = "", const std::string &title = "",
               const nlohmann::ordered_json &own = nullptr);

/// Numbers for a data file alone.
Column numbers(const std::string &name, const std::string &unit, const std::vector<double> &values);

/// Numbers for a data file alone, of each of @p rows: @p value is a member, or is called with the row.
template <typename Rows, typename Value>
Column numbers(const std::string &name, const std::string &unit, const Rows &rows, Value value)
{
  Column column = { { "", name, unit }, {} };
  for (const auto &row : rows)
    column.cells.push_back(std::invoke(value, row));
  return column;
}

/// Numbers for a data file alone, row by row; @p columns are their names and units.
Table number_rows(const std::string &title, const std::vector<std::pair<std::string, std::string>> &columns,
                  const std::vector<std::vector<double>> &rows);

/// A table of one row as a list of what it is, with its unit, and how large: objects with "what" and "is".
nlohmann::ordered_json name_value_list(const Table &table);

/// A cell as people read it on the console or in a report; @p missing where there is none.
std::string shown(const Column &column, std::size_t row, const std::string &missing, bool on_console = false);

/// Makes 0 of what is less than @p rounding in these @p keys (parted by blanks) of each of @p rows: rounding
/// errors are for data files.
void zero_rounding_errors(nlohmann::ordered_json &rows, const std::string &keys, double rounding);

} // namespace stemware::pipeline
