#pragma once

#include "fem/pipeline/document/number_format.h"
#include "fem/pipeline/document/quantity.h"

#include <nlohmann/json.hpp>

#include <string>
#include <utility>
#include <vector>

namespace stemware::pipeline
{

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
nlohmann::ordered_json as_list(const Table &table);

/// A cell as people read it on the console or in a report; @p missing where there is none.
std::string shown(const Column &column, std::size_t row, const std::string &missing, bool on_console = false);

/// Makes 0 of what is less than @p rounding in these @p keys (parted by blanks) of each of @p rows: rounding
/// errors are for data files.
void leave_out_rounding(nlohmann::ordered_json &rows, const std::string &keys, double rounding);

} // namespace stemware::pipeline
