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
  char separator = '\n';      ///< between the cells; line end: one cell per row

  /// Returns @p cell with a decimal point for a decimal comma ("4,007 mm"), unless commas separate cells.
  std::string with_point(std::string cell) const;
};

/// Reads a table from @p text. Semicolons, tabs or commas separate the cells: the first of these that the
/// first row has outside quotes. Without any, a row has one cell, or, if @p blanks_separate, cells separated
/// by blanks. A first line "sep=;" of a spreadsheet names the separator instead. Cells in double quotes may
/// hold separators, line ends and doubled quotes (RFC 4180). Empty lines and lines that begin with # are
/// skipped. Throws BadInput, with @p origin and the line, for an open quote and an invalid "sep=".
TextTable parse_table(const std::string &origin, const std::string &text, bool blanks_separate = false);

/// Heading of a column.
struct ColumnHeading
{
  std::string name;
  std::string unit; ///< text in the last round or square brackets, or empty
};

/// Splits "Motion/Mass (g)" into name and unit.
ColumnHeading parse_heading(const std::string &cell);

/// Returns "setting, line 3, column 2: "; @p column is counted from 0, in the text from 1.
std::string position_in_table(const std::string &setting, const TableRow &row, std::size_t column);

} // namespace stemware::pipeline
