#pragma once

#include <string>
#include <vector>

namespace stemware::pipeline
{

/// A column of a file of numbers.
struct FileColumn
{
  std::vector<std::string> names; ///< what a header may call it; messages use the first
  std::string unit;               ///< of SI
};

/// Row of a file: one number for each column, in SI units.
struct FileRow
{
  std::vector<double> values;
  unsigned int line = 0; ///< where it stands in the file, counted from 1
};

/// A file of numbers: one row a line, parted by semicolons or tabs (a comma is then a decimal one, as in
/// "4,007;3,058"), or by commas, or by blanks. A first line such as
/// "r (mm), z (mm)" names the columns in their order, each with its unit where that is not the one of SI;
/// empty lines and lines that begin with # are skipped. Throws BadInput with one sentence, which begins with
/// @p setting ("Glass/Profile file = my.csv") and names the line: also for what is no regular file
/// (read_lines()).
std::vector<FileRow> read_column_file(const std::string &setting, const std::string &file,
                                      const std::vector<FileColumn> &columns);

} // namespace stemware::pipeline
