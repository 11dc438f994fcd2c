#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace stemware::pipeline
{

/// Writes a whole file; throws OutputFailure, with one sentence, unless every byte has been taken by the
/// disk.
void write_text_file(const std::filesystem::path &file, const std::string &text);

/// Writes a whole file that stands alone, outside a folder of results: it appears under its name when it is
/// complete, and replaces an older one. Throws OutputFailure with one sentence.
void replace_text_file(const std::filesystem::path &file, const std::string &text);

/// One column of numbers, all columns of a table being equally long.
struct DataColumn
{
  std::string name;
  std::string unit; ///< "1" for pure numbers
  std::vector<double> values;
};

/// A table for eye, gnuplot and numpy: "# title", one line "# 1: name (unit)" per column, then aligned rows
/// of full-precision numbers.
std::string data_table(const std::string &title, const std::vector<DataColumn> &columns);

} // namespace stemware::pipeline
