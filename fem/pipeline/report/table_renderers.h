#pragma once

#include "fem/pipeline/document/table.h"

#include <string>

/// The forms of a table.
namespace stemware::pipeline
{

/// Returns the table as text for numpy: "# title", one line "# 1: name (unit)" per column, then aligned rows
/// of full-precision numbers; flags are 1 and 0, missing values nan.
std::string data_table(const Table &table);

/// A CSV file by RFC 4180: commas, CRLF, fields with commas, quotes or line ends in double quotes. The header
/// reads "name (unit)"; numbers have all their digits.
std::string csv_table(const Table &table);

/// The lines of a table that fits the console, each with its line break: the title, the labels with their
/// units, the rows. Columns that have no room follow below, beside the first column again. Words stand to the
/// left, numbers to the right.
std::string console_table(const Table &table);

} // namespace stemware::pipeline
