#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace stemware::pipeline
{

/// Column of a file of numbers.
struct FileColumn
{
  std::vector<std::string> names; ///< names in a heading, in small letters; messages use the first
  std::string unit;               ///< SI unit
};

/// Row of a file: one number for each column, in SI units.
struct FileRow
{
  std::vector<double> values;
  unsigned int line = 0; ///< line of the file, counted from 1
};

/// Treatment of a row in which a column has no value (an empty cell, "nan" or "-").
enum class MissingValues
{
  refused,
  skipped
};

/// Columns of numbers that were found in a table.
struct ColumnTable
{
  std::vector<FileRow> rows;
  std::vector<std::string> headings; ///< as they stand in the file; empty without a heading
  std::vector<std::string> units;    ///< as they stand in the file; empty text: the SI unit is assumed
  std::size_t n_skipped = 0;         ///< rows without a value

  /// Returns one clause that says which columns, units and rows were read and how many rows were skipped.
  std::string summary(const std::vector<FileColumn> &columns) const;
};

/// Finds @p columns in the table @p text (parse_table()). A heading names them in any order, among other
/// columns, with the unit in round or square brackets or after a comma, a slash or a blank, or in a row of
/// units below; lines above the heading are titles. Without a heading the rows are the columns in their
/// order, in SI units. Quoted numbers of a table that is separated by commas may have decimal commas. Throws
/// BadInput with one sentence, which begins with @p setting and names line, column and remedy; also for
/// commas that may stand for decimals or for thousands.
ColumnTable parse_columns(const std::string &setting, const std::string &text,
                          const std::vector<FileColumn> &columns,
                          MissingValues missing_values = MissingValues::refused);

/// Returns whether a heading of the table @p text names all @p columns. Throws BadInput as parse_table(), and
/// for a heading that names a column twice.
bool has_columns(const std::string &setting, const std::string &text, const std::vector<FileColumn> &columns);

} // namespace stemware::pipeline
