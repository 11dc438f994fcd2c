#include "fem/pipeline/base/failures.h"
#include "fem/pipeline/base/numbers.h"
#include "fem/pipeline/study/quantity_text.h"
#include "fem/pipeline/study/table_file.h"

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

/// Returns the unit after the name of @p column in the heading @p cell, in SI units; 1 if the heading has no
/// unit; std::nullopt if @p cell does not name the column.
std::optional<double> unit_in(const std::string &cell, const FileColumn &column)
{
  const std::string typed = as_typed(cell), heading = boost::to_lower_copy(typed);
  for (const std::string &name : column.names)
    if (heading.rfind(name, 0) == 0 &&
        (heading.size() == name.size() || std::string(" ([,/").find(heading[name.size()]) != heading.npos))
    {
      const std::string unit = boost::trim_copy_if(typed.substr(name.size()), boost::is_any_of(" ()[],/"));
      if (const auto size = unit.empty() ? std::optional(1.) : parse_quantity("1 " + unit, column.unit))
        return size;
    }
  return std::nullopt;
}

std::size_t n_cells(const TableRow<std::string> &row)
{
  const auto last =
    std::find_if(row.cells.rbegin(), row.cells.rend(), [](const auto &cell) { return !cell.empty(); });
  return static_cast<std::size_t>(row.cells.rend() - last);
}

struct Layout
{
  std::size_t first_row = 0;
  std::vector<std::size_t> places; ///< position of each column in a row
  std::vector<double> units;       ///< units of the columns in SI units
  std::size_t n_columns = 0;
};

class ColumnReader
{
public:
  ColumnReader(const std::string &setting, const std::string &text, const std::vector<FileColumn> &columns)
      : setting(setting)
      , columns(columns)
      , table(parse_table(setting, text, true))
  {
    for (const FileColumn &column : columns)
    {
      names.push_back(column.names.front());
      header.push_back(names.back() + " (" + usual_units(column.unit).front() + ")");
    }
  }

  std::vector<TableRow<double>> read()
  {
    ensure(!table.rows.empty(), no_rows());
    const std::optional<Layout> by_heading = layout_by_heading();
    const Layout layout = by_heading ? *by_heading : layout_without_heading();
    require_clear_commas(layout);
    std::vector<TableRow<double>> rows;
    for (std::size_t i = layout.first_row; i < table.rows.size(); ++i)
      rows.push_back({ values_in(table.rows[i], layout), table.rows[i].line });
    ensure(!rows.empty(), no_rows());
    return rows;
  }

private:
  std::string no_rows() const
  {
    return setting + " has no rows with numbers; write " + std::to_string(columns.size()) +
           " numbers a line, " + boost::join(names, ", ") + ".";
  }

  std::string remedy() const
  {
    return "write " + std::to_string(columns.size()) + " numbers, " + boost::join(names, ", ") +
           ", in SI units or in those of a first line \"" + boost::join(header, ", ") + "\".";
  }

  std::optional<double> number_in(const std::string &cell) const
  {
    return parse_number(table.with_point(cell));
  }

  std::optional<Layout> layout_by_heading() const
  {
    const TableRow<std::string> &row = table.rows.front();
    if (n_cells(row) >= columns.size() &&
        std::all_of(row.cells.begin(), row.cells.begin() + static_cast<std::ptrdiff_t>(n_cells(row)),
                    [&](const auto &cell) { return number_in(cell).has_value(); }))
      return std::nullopt;
    Layout layout;
    std::vector<std::string> headings;
    for (const FileColumn &column : columns)
    {
      const std::size_t n_before = headings.size();
      for (std::size_t place = 0; place < row.cells.size(); ++place)
        if (const auto unit = unit_in(row.cells[place], column))
        {
          layout.places.push_back(place);
          layout.units.push_back(*unit);
          headings.push_back(row.cells[place]);
        }
      if (headings.size() == n_before)
        return std::nullopt;
    }
    ensure(layout.places.size() == columns.size(),
           setting + ", line " + std::to_string(row.line) + ": the header names a column twice (" +
             shortened(boost::join(headings, ", ")) + "); rename all but one of them.");
    layout.first_row = 1;
    layout.n_columns = n_cells(row);
    return layout;
  }

  /// Returns the layout of a table without a heading: the columns in their given order, in SI units. Throws
  /// BadInput if the first row seems to be a heading that does not name the columns.
  Layout layout_without_heading() const
  {
    const TableRow<std::string> &row = table.rows.front();
    const bool has_number = std::any_of(row.cells.begin(), row.cells.end(),
                                        [&](const auto &cell) { return number_in(cell).has_value(); });
    const bool is_long = n_cells(row) > columns.size() && !number_in(row.cells.front());
    ensure((n_cells(row) != columns.size() || has_number) && !is_long,
           setting + ", line " + std::to_string(row.line) + ": the header \"" +
             shortened(boost::join(row.cells, ", ")) + "\" does not name the columns " +
             boost::join(names, ", ") + " with units of theirs; write \"" + boost::join(header, ", ") +
             "\", or leave the header out.");
    Layout layout = { 0, {}, std::vector<double>(columns.size(), 1.), columns.size() };
    for (std::size_t i = 0; i < columns.size(); ++i)
      layout.places.push_back(i);
    return layout;
  }

  /// Throws BadInput if commas in numbers may be thousands separators, not decimal marks: if other numbers
  /// have points, or if the table is comma-separated and three digits follow every comma.
  void require_clear_commas(const Layout &layout) const
  {
    std::string with_comma;
    bool has_point = false, has_decimals = table.separator != ',';
    for (std::size_t i = layout.first_row; i < table.rows.size(); ++i)
      for (const std::size_t place : layout.places)
      {
        const TableRow<std::string> &row = table.rows[i];
        const std::string cell = place < row.cells.size() ? as_typed(row.cells[place]) : "";
        const auto comma = cell.find(',');
        has_point = has_point || cell.find('.') != cell.npos;
        if (comma == cell.npos)
          continue;
        if (with_comma.empty())
          with_comma =
            position_in_table(setting, row.line, place) + "the comma of \"" + shortened(cell) + "\"";
        const std::string whole = boost::trim_left_copy_if(cell.substr(0, comma), boost::is_any_of("+-"));
        has_decimals = has_decimals || whole == "0" || cell.size() - comma != 4;
      }
    ensure(with_comma.empty() || (has_decimals && !has_point),
           with_comma +
             " may stand for decimals or for thousands; write all numbers with a decimal point and "
             "nothing between thousands.");
  }

  std::vector<double> values_in(const TableRow<std::string> &row, const Layout &layout) const
  {
    const std::size_t n = n_cells(row);
    const bool is_short = n < layout.n_columns && (layout.first_row == 0 || table.separator == ' ');
    const bool has_two_commas = table.separator == ',' && n == 2 * layout.n_columns;
    ensure(n <= layout.n_columns && !is_short,
           setting + ", line " + std::to_string(row.line) + ": the row has " +
             (n == 1 ? std::string("1 cell") : std::to_string(n) + " cells") + ", but there are " +
             std::to_string(layout.n_columns) + " columns; " +
             (has_two_commas ? "if commas are decimal too, separate the cells by semicolons. Else " : "") +
             remedy());
    std::vector<double> values;
    for (std::size_t i = 0; i < columns.size(); ++i)
    {
      const std::string cell = layout.places[i] < row.cells.size() ? row.cells[layout.places[i]] : "";
      const auto number = parse_number(with_decimal_point(cell));
      ensure(number.has_value(), position_in_table(setting, row.line, layout.places[i]) + "\"" +
                                   shortened(cell) + "\" is not a number; " + remedy());
      values.push_back(*number * layout.units[i]);
    }
    return values;
  }

  const std::string &setting;
  const std::vector<FileColumn> &columns;
  const TextTable table;
  std::vector<std::string> names, header;
};

} // namespace

std::vector<TableRow<double>> parse_columns(const std::string &setting, const std::string &text,
                                            const std::vector<FileColumn> &columns)
{
  return ColumnReader(setting, text, columns).read();
}

} // namespace stemware::pipeline
