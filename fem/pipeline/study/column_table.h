#pragma once

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

/// Finds @p columns in the table @p text (parse_table()). A heading names them in any order, among other
/// columns, with the unit in round or square brackets or after a comma, a slash or a blank. Without a heading
/// the rows are the columns in their order, in SI units. Quoted numbers of a table that is separated by
/// commas may have decimal commas. Throws BadInput with one sentence, which begins with @p setting and names
/// line, column and remedy; also for commas that may stand for decimals or for thousands.
std::vector<FileRow> parse_columns(const std::string &setting, const std::string &text,
                                   const std::vector<FileColumn> &columns);

} // namespace stemware::pipeline
