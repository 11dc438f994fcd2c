#pragma once

#include "fem/pipeline/report/render/number_format.h"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <functional>
#include <initializer_list>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace stemware::pipeline
{

/// Everything about a column but its values: where and how it is named, its unit, its digits.
struct Quantity
{
  using Digits = std::string (*)(double);

  Quantity(const std::string &key, const std::string &name = "", const std::string &unit = "1",
           const std::string &heading = "", const std::string &label = "",
           Digits digits = format::significant<6>, Digits console_digits = nullptr)
      : key(key)
      , name(name)
      , unit(unit)
      , heading(heading)
      , label(label)
      , digits(digits)
      , console_digits(console_digits)
  {
  }

  std::string key;  ///< in summary.json, and what the column is found by; columns of one row whose keys are
                    ///< equal and end in [] make a list: "torque[]"
  std::string name; ///< in data files, without its unit: "terminal omega"
  std::string unit; ///< SI; "1" for pure numbers, empty for words
  std::string heading;   ///< in reports, without its unit: "terminal spin"
  std::string label;     ///< on the console, without its unit; may have several lines: "change\nof spin"
  Digits digits;         ///< for people
  Digits console_digits; ///< on the console, where those differ; or null

  /// A variant for one table: the quantity with another value of a @p member.
  template <typename Member, typename Value>
  Quantity with(Member Quantity::*member, const Value &value) const
  {
    Quantity variant = *this;
    variant.*member = value;
    return variant;
  }
};

/// A value of a table; nothing where it does not exist: nan in data files, empty in CSV, null in JSON, a dash
/// for people.
using Cell = std::variant<std::monostate, bool, std::int64_t, double, std::string, nlohmann::ordered_json>;

/// A number, word, flag or JSON value, or a std::optional of one, as a cell.
template <typename Value>
Cell to_cell(const Value &value)
{
  using std::is_same_v;
  if constexpr (is_same_v<Value, bool> || is_same_v<Value, Cell>)
    return value;
  else if constexpr (is_same_v<Value, nlohmann::ordered_json>)
    return Cell(std::in_place_type<nlohmann::ordered_json>, value);
  else if constexpr (std::is_integral_v<Value>)
    return Cell(static_cast<std::int64_t>(value));
  else if constexpr (std::is_floating_point_v<Value>)
    return Cell(static_cast<double>(value));
  else if constexpr (std::is_convertible_v<Value, std::string>)
    return Cell(std::string(value));
  else
    return value ? to_cell(*value) : Cell();
}

struct Column
{
  Quantity quantity;
  std::vector<Cell> cells;
  double rounding = 0;    ///< people read 0 where the value is smaller than this; files keep it
  double uncertainty = 0; ///< where known, people read no more digits than it allows; files have all
};

/// A quantity of each of @p rows: @p value is a member, or is called with the row.
template <typename Rows, typename Value>
Column column(const Quantity &quantity, const Rows &rows, Value value, double rounding = 0)
{
  Column result = { quantity, {}, rounding, 0 };
  for (const auto &row : rows)
    result.cells.push_back(to_cell(std::invoke(value, row)));
  return result;
}

/// A quantity whose values are a list.
template <typename Value>
Column column(const Quantity &quantity, const std::vector<Value> &values)
{
  return column(quantity, values, [](const Value &value) { return value; });
}

/// Numbers for a data file alone.
Column numbers(const std::string &name, const std::string &unit, const std::vector<double> &values);

/// A single value, for tables of one row.
template <typename Value>
Column single(const Quantity &quantity, const Value &value, double rounding = 0)
{
  return { quantity, { to_cell(value) }, rounding, 0 };
}

/// Columns of equal length under a title. Renderers (table_renderers.h) show all columns of what they are
/// given in this order; with() says which those are.
struct Table
{
  std::string title;
  std::vector<Column> columns;

  std::size_t n_rows() const { return columns.empty() ? 0 : columns.front().cells.size(); }

  /// The columns with these keys (parted by blanks) in this order, under another title. Throws
  /// std::out_of_range for a key that no column has.
  Table with(const std::string &title, const std::string &keys) const;

  /// The quantity of the column with that key, to be made a variant for this table. Throws as with().
  Quantity &operator[](const std::string &key);
};

/// Numbers for a data file alone, row by row; @p columns are their names and units.
Table number_rows(const std::string &title, const std::vector<std::pair<std::string, std::string>> &columns,
                  const std::vector<std::vector<double>> &rows);

/// A table of words for people, row by row. Cells that look like numbers are aligned as numbers are.
Table words(const std::string &title, const std::vector<std::string> &headings,
            const std::vector<std::vector<std::string>> &rows);

/// A table of one row as one of two columns: what it is, with its unit, and how large. For reports.
Table as_list(const Table &table);

/// "name (unit)"; the name alone where there is no unit, or the unit is 1 and @p ones is false.
std::string with_unit(const std::string &name, const std::string &unit, bool ones = true);

/// Heading of a quantity in reports, with its unit unless that is 1.
std::string heading_with_unit(const Quantity &quantity);

/// A cell as people read it on the console or in a report; @p missing where there is none.
std::string shown(const Column &column, std::size_t row, const std::string &missing, bool on_console = false);

} // namespace stemware::pipeline
