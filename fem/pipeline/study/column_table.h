#pragma once

#include "fem/pipeline/study/table_file.h"

#include <string>
#include <vector>

namespace stemware::pipeline
{

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

} // namespace stemware::pipeline
