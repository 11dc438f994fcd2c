#include "fem/pipeline/study/column_table.h"

#include "fem/pipeline/study/quantity_text.h"
#include "fem/pipeline/study/table_file.h"
#include "fem/pipeline/support/failures.h"
#include "fem/pipeline/support/numbers.h"

#include <boost/algorithm/string/case_conv.hpp>
#include <boost/algorithm/string/classification.hpp>
#include <boost/algorithm/string/join.hpp>
#include <boost/algorithm/string/trim.hpp>

#include <algorithm>
#include <optional>

namespace stemware::pipeline
{

namespace
{

/// Titles and settings of an instrument are shorter.
constexpr std::size_t max_rows_above_heading = 50;

/// Returns the unit behind the column's name, empty if there is none; std::nullopt for another heading.
std::optional<std::string> unit_text_in(const std::string &cell, const FileColumn &column)
{
  const std::string typed = as_typed(cell), heading = boost::to_lower_copy(typed);
  for (const std::string &name : column.names)
    if (heading.rfind(name, 0) == 0 &&
        (heading.size() == name.size() || std::string(" ([,/").find(heading[name.size()]) != heading.npos))
    {
      const std::string unit = boost::trim_copy_if(typed.substr(name.size()), boost::is_any_of(" ()[],/"));
      if (unit.empty() || parse_quantity("1 " + unit, column.unit))
        return unit;
    }
  return std::nullopt;
}

/// Number of cells without the empty ones at the end.
std::size_t n_cells(const TableRow &row)
{
  const auto last =
    std::find_if(row.cells.rbegin(), row.cells.rend(), [](const auto &cell) { return !cell.empty(); });
  return static_cast<std::size_t>(row.cells.rend() - last);
}

/// Where the columns stand in a table.
struct Layout
{
  std::size_t first_row = 0;         ///< of numbers
  std::vector<std::size_t> places;   ///< of the columns in a row
  std::vector<std::string> headings; ///< as in ColumnTable
  std::vector<std::string> units;    ///< as in ColumnTable
  std::size_t n_columns = 0;         ///< of the file
};

/// Reader of the numbers of one table.
class ColumnReader
{
public:
  ColumnReader(const std::string &setting, const std::vector<FileColumn> &columns,
               MissingValues missing_values)
      : setting(setting)
      , columns(columns)
      , missing_values(missing_values)
  {
    for (const FileColumn &column : columns)
    {
      names.push_back(column.names.front());
      header.push_back(names.back() + " (" + usual_units(column.unit).front() + ")");
    }
  }

  /// Leaves in `table` the text in the cells that the layout by a heading needs; std::nullopt without one.
  std::optional<Layout> layout_by_heading(const std::string &text)
  {
    table = parse_table(setting, text, true);
    ensure(!table.rows.empty(), no_rows());
    commas_are_decimal = table.separator != ',';
    std::optional<Layout> layout;
    // A title above the heading may lack the separator, and blanks would join empty cells.
    const bool is_sure = table.separator != ' ' && table.separator != '\n';
    const bool has_heading = !is_row_of_numbers(table.rows.front());
    if (has_heading && is_sure)
      layout = find_heading();
    if (has_heading)
      for (const char separator : { ';', '\t', ',', ' ' })
        if (!layout && (separator != ' ' || !is_sure))
        {
          table = parse_table(setting, text, true, separator);
          layout = find_heading();
        }
    return layout;
  }

  ColumnTable read(const std::string &text)
  {
    std::optional<Layout> layout = layout_by_heading(text);
    if (!layout)
    {
      table = parse_table(setting, text, true);
      layout = layout_without_heading();
    }
    ColumnTable found;
    found.headings = layout->headings;
    found.units = layout->units;
    decide_about_commas(*layout);
    for (std::size_t i = 0; i < columns.size(); ++i)
      factors.push_back(found.units[i].empty() ? 1.
                                               : *parse_quantity("1 " + found.units[i], columns[i].unit));
    for (std::size_t i = layout->first_row; i < table.rows.size(); ++i)
      if (const auto values = values_in(table.rows[i], *layout); !values.empty())
        found.rows.push_back({ values, table.rows[i].line });
      else
        ++found.n_skipped;
    ensure(!found.rows.empty(), no_rows());
    return found;
  }

private:
  std::string no_rows() const
  {
    return setting + " has no rows with numbers; write " + std::to_string(columns.size()) +
           " numbers a line, " + boost::join(names, ", ") + ".";
  }

  /// "2 numbers, t, v, in SI units or in those of a first line "t (ms), v (cm/s)"."
  std::string remedy() const
  {
    return "write " + std::to_string(columns.size()) + " numbers, " + boost::join(names, ", ") +
           ", in SI units or in those of a first line \"" + boost::join(header, ", ") + "\".";
  }

  std::optional<double> number_in(std::string cell) const
  {
    const auto comma = cell.find(',');
    if (commas_are_decimal && comma != cell.npos && cell.find_first_of(",.", comma + 1) == cell.npos &&
        cell.find('.') == cell.npos)
      cell[comma] = '.';
    return parse_number(cell);
  }

  bool is_row_of_numbers(const TableRow &row) const
  {
    const auto end = row.cells.begin() + static_cast<std::ptrdiff_t>(n_cells(row));
    return n_cells(row) >= columns.size() &&
           std::all_of(row.cells.begin(), end, [&](const auto &cell) { return number_in(cell).has_value(); });
  }

  /// Returns the layout by the first row that names all columns; std::nullopt without such a row.
  std::optional<Layout> find_heading()
  {
    commas_are_decimal = table.separator != ',';
    for (std::size_t i = 0; i < std::min(table.rows.size(), max_rows_above_heading); ++i)
    {
      const TableRow &row = table.rows[i];
      if (is_row_of_numbers(row))
        return std::nullopt;
      Layout layout;
      for (const FileColumn &column : columns)
        for (std::size_t place = 0; place < row.cells.size(); ++place)
          if (const auto unit = unit_text_in(row.cells[place], column))
          {
            layout.places.push_back(place);
            layout.headings.push_back(row.cells[place]);
            layout.units.push_back(*unit);
          }
      if (!names_each_column(row))
        continue;
      ensure(layout.places.size() == columns.size(),
             setting + ", line " + std::to_string(row.line) + ": the header names a column twice (" +
               shortened(boost::join(layout.headings, ", ")) + "); rename all but one of them.");
      layout.first_row = i + 1;
      layout.n_columns = n_cells(row);
      take_row_of_units(layout);
      return layout;
    }
    return std::nullopt;
  }

  bool names_each_column(const TableRow &row) const
  {
    return std::all_of(columns.begin(), columns.end(),
                       [&](const FileColumn &column)
                       {
                         return std::any_of(row.cells.begin(), row.cells.end(),
                                            [&](const auto &cell)
                                            { return unit_text_in(cell, column).has_value(); });
                       });
  }

  /// Takes the units of a row below a heading without units.
  void take_row_of_units(Layout &layout) const
  {
    if (boost::join(layout.units, "") != "" || layout.first_row == table.rows.size())
      return;
    const TableRow &row = table.rows[layout.first_row];
    std::vector<std::string> units;
    for (std::size_t i = 0; i < columns.size(); ++i)
      if (layout.places[i] < row.cells.size())
      {
        const std::string unit = boost::trim_copy_if(row.cells[layout.places[i]], boost::is_any_of(" ()[]"));
        if (!unit.empty() && !parse_number(unit) && parse_quantity("1 " + unit, columns[i].unit))
          units.push_back(unit);
      }
    if (units.size() == columns.size())
    {
      layout.units = units;
      ++layout.first_row;
    }
  }

  /// Returns the columns in their order. Throws BadInput if the first row is a heading.
  Layout layout_without_heading()
  {
    commas_are_decimal = table.separator != ',';
    const TableRow &row = table.rows.front();
    ensure(std::find(row.cells.begin(), row.cells.end(), "->") == row.cells.end(),
           setting + ", line " + std::to_string(row.line) + ": \"" + shortened(row.cells.front()) +
             " ->\" is the clock of a serial monitor; switch its timestamps off, or delete it in each line.");
    ensure(n_cells(row) != columns.size() ||
             std::any_of(row.cells.begin(), row.cells.end(),
                         [&](const auto &cell) { return number_in(cell).has_value(); }),
           bad_heading(row));
    const bool is_long = n_cells(row) > columns.size() && !number_in(row.cells.front());
    ensure(!is_long, bad_heading(row));
    Layout layout;
    for (std::size_t i = 0; i < columns.size(); ++i)
      layout.places.push_back(i);
    layout.units.resize(columns.size());
    layout.n_columns = columns.size();
    return layout;
  }

  std::string bad_heading(const TableRow &row) const
  {
    return setting + ", line " + std::to_string(row.line) + ": the header \"" +
           shortened(boost::join(row.cells, ", ")) + "\" does not name the columns " +
           boost::join(names, ", ") + " with units of theirs; write \"" + boost::join(header, ", ") +
           "\", or leave the header out.";
  }

  /// Finds out whether commas stand for decimals. Throws BadInput if they may stand for thousands: beside
  /// numbers with points, or, in a table that is separated by commas, with three digits behind all of them.
  void decide_about_commas(const Layout &layout)
  {
    const bool may_be_thousands = table.separator == ',';
    std::string with_comma;
    bool has_point = false, has_decimals = !may_be_thousands;
    for (std::size_t i = layout.first_row; i < table.rows.size(); ++i)
      for (const std::size_t place : layout.places)
      {
        const TableRow &row = table.rows[i];
        const std::string cell = place < row.cells.size() ? as_typed(row.cells[place]) : "";
        const auto comma = cell.find(',');
        has_point = has_point || cell.find('.') != cell.npos;
        if (comma == cell.npos)
          continue;
        if (with_comma.empty())
          with_comma = position_in_table(setting, row, place) + "the comma of \"" + shortened(cell) + "\"";
        const std::string whole = boost::trim_left_copy_if(cell.substr(0, comma), boost::is_any_of("+-"));
        has_decimals = has_decimals || whole == "0" || cell.size() - comma != 4;
      }
    ensure(with_comma.empty() || (has_decimals && !has_point),
           with_comma +
             " may stand for decimals or for thousands; write all numbers with a decimal point and "
             "nothing between thousands.");
    commas_are_decimal = true;
  }

  /// Returns the values in SI units; no value for a row that is skipped.
  std::vector<double> values_in(const TableRow &row, const Layout &layout) const
  {
    const std::size_t n = n_cells(row);
    const bool is_short = n < layout.n_columns && (layout.headings.empty() || table.separator == ' ');
    const bool has_two_commas = table.separator == ',' && n == 2 * layout.n_columns;
    ensure(n <= layout.n_columns && (!is_short || (n == 0 && missing_values == MissingValues::skipped)),
           setting + ", line " + std::to_string(row.line) + ": the row has " +
             (n == 1 ? std::string("1 cell") : std::to_string(n) + " cells") + ", but there are " +
             std::to_string(layout.n_columns) + " columns; " +
             (has_two_commas ? "if commas are decimal too, separate the cells by semicolons. Else " : "") +
             remedy());
    std::vector<double> values;
    for (std::size_t i = 0; i < columns.size(); ++i)
    {
      const std::string cell = layout.places[i] < row.cells.size() ? row.cells[layout.places[i]] : "";
      const std::string small = boost::to_lower_copy(cell);
      if ((small.empty() || small == "nan" || small == "-") && missing_values == MissingValues::skipped)
        return {};
      const auto number = number_in(cell);
      ensure(number.has_value(), position_in_table(setting, row, layout.places[i]) + "\"" + shortened(cell) +
                                   "\" is not a number; " + remedy());
      values.push_back(*number * factors[i]);
    }
    return values;
  }

  const std::string &setting;
  const std::vector<FileColumn> &columns;
  const MissingValues missing_values;
  std::vector<std::string> names, header;
  std::vector<double> factors; ///< from the file's units to those of SI
  TextTable table;
  bool commas_are_decimal = false;
};

} // namespace

std::string ColumnTable::summary(const std::vector<FileColumn> &columns) const
{
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < columns.size(); ++i)
    parts.push_back(columns[i].names.front() + " in " +
                    (units[i].empty() ? columns[i].unit + " (assumed)" : units[i]) +
                    (headings.empty() ? "" : " from \"" + shortened(headings[i]) + "\""));
  return boost::join(parts, ", ") + "; " + std::to_string(rows.size()) +
         (rows.size() == 1 ? " row" : " rows") +
         (n_skipped == 0 ? "" : ", " + std::to_string(n_skipped) + " without a value skipped");
}

ColumnTable parse_columns(const std::string &setting, const std::string &text,
                          const std::vector<FileColumn> &columns, MissingValues missing_values)
{
  return ColumnReader(setting, columns, missing_values).read(text);
}

bool has_columns(const std::string &setting, const std::string &text, const std::vector<FileColumn> &columns)
{
  return ColumnReader(setting, columns, MissingValues::skipped).layout_by_heading(text).has_value();
}

} // namespace stemware::pipeline
