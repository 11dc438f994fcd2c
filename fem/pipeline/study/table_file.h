#pragma once

#include <string>
#include <vector>

namespace stemware::pipeline
{

/// Row of a text table.
struct TableRow
{
  std::vector<std::string> cells; ///< without blanks at their ends
  unsigned int line = 0;          ///< line of the file in which the row begins, counted from 1
};

/// Table of texts, as exported by spreadsheets, phones and instruments.
struct TextTable
{
  std::vector<TableRow> rows; ///< a heading, if there is one, comes first
  char separator = '\n';      ///< between the cells; a line end if the first row has one cell

  /// Returns @p cell with a decimal point in place of a decimal comma, "4.007 mm" for "4,007 mm",
  /// unless commas separate the cells.
  std::string with_point(std::string cell) const;
};

/// Reads a table from @p text: cells separated by semicolons, tabs or commas, whichever of them the first row
/// has, in this order, outside quotes. A first row without any of them has one cell, or, if
/// @p blanks_separate, cells separated by blanks. Cells in double quotes may hold separators, line ends and
/// doubled quotes (RFC 4180). Empty lines and lines that begin with # are skipped. A first line "sep=;" of a
/// spreadsheet names the separator in place of the first row. Throws BadInput, which begins with @p origin
/// and names the line, for a quote that is not closed and for a "sep=" with another separator.
TextTable parse_table(const std::string &origin, const std::string &text, bool blanks_separate = false);

/// Heading of a column.
struct ColumnHeading
{
  std::string name;
  std::string unit; ///< text in the last round or square brackets; empty if there are none
};

/// Splits "Motion/Mass (g)" into name and unit.
ColumnHeading parse_heading(const std::string &cell);

/// Returns "setting, line 3, column 2: ", with the column counted from 0 as argument and from 1 in the text.
std::string position_in_table(const std::string &setting, const TableRow &row, std::size_t column);

} // namespace stemware::pipeline
