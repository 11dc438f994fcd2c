#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace stemware::pipeline
{

/// Row of a table.
template <typename Cell>
struct TableRow
{
  std::vector<Cell> cells;
  unsigned int line = 0; ///< line of the file in which the row begins, counted from 1
};

/// Returns @p cell with a decimal point for its only comma, if it has no point.
std::string with_decimal_point(std::string cell);

/// Table of texts, as exported by spreadsheets, phones and instruments.
struct TextTable
{
  /// Cells without blanks at their ends; a heading, if there is one, comes first.
  std::vector<TableRow<std::string>> rows;
  char separator = '\n'; ///< between the cells; line end: one cell per row

  /// Returns @p cell with a decimal point for a decimal comma ("4,007 mm"), unless commas separate cells.
  std::string with_point(const std::string &cell) const
  {
    return separator == ',' ? cell : with_decimal_point(cell);
  }
};

/// Reads a table from @p text. Semicolons, tabs or commas separate the cells: the first of these that the
/// first row has outside quotes. Without any, a row has one cell, or, if @p blanks_separate, cells separated
/// by blanks. A first line "sep=;" of a spreadsheet names the separator instead. Cells in double quotes may
/// hold separators, line ends and doubled quotes (RFC 4180). Empty lines and lines that begin with # are
/// skipped. Throws BadInput, with @p origin and the line, for an open quote and an invalid "sep=".
TextTable parse_table(const std::string &origin, const std::string &text, bool blanks_separate = false);

/// Column of a file of numbers.
struct FileColumn
{
  std::vector<std::string> names; ///< allowed headings in lower case; messages use the first
  std::string unit;               ///< SI unit
};

/// Reads @p columns, one number in SI units for each, from the table @p text (parse_table()). A heading names
/// them in any order, among others, with the unit in round or square brackets or after a comma, slash or
/// blank; without a heading, the columns are as given and in SI units. Quoted numbers may have decimal commas
/// if commas separate the cells. Throws BadInput, beginning with @p setting, with line, column and remedy;
/// also for ambiguous commas.
std::vector<TableRow<double>> parse_columns(const std::string &setting, const std::string &text,
                                            const std::vector<FileColumn> &columns);

/// Splits a heading "Motion/Mass (g)" into name and unit, the text in the last round or square brackets, or
/// empty.
std::pair<std::string, std::string> parse_heading(const std::string &cell);

/// Returns "setting, line 3, column 2: "; @p column is counted from 0, in the text from 1.
std::string position_in_table(const std::string &setting, unsigned int line, std::size_t column);

} // namespace stemware::pipeline
