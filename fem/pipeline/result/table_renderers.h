#pragma once

#include "fem/pipeline/analysis/quantity.h"

#include <string>

/// The forms of a table.
namespace stemware::pipeline
{

/// Returns a cell as text for console or page; @p missing for a missing value.
std::string shown(const Quantity &quantity, const Json &cell, const std::string &missing);

/// Returns a table of one row as a list: a row for each column, with its heading and unit, and its value as
/// text.
Table as_list(const Table &row);

/// Returns the table as text for numpy: "# title", one line "# 1: name (unit)" per column, then aligned rows
/// of full-precision numbers; flags are 1 and 0, missing values nan.
std::string data_table(const Table &table);

/// Returns a CSV file by RFC 4180: commas, CRLF, fields with commas, quotes or line ends in double quotes.
/// Header "name (unit)"; numbers in full precision.
std::string csv_table(const Table &table);

/// Returns a table for the console: title, labels with units, rows. Columns that do not fit follow below,
/// with the first column repeated. Words are left-aligned, numbers right-aligned.
std::string console_table(const Table &table);

} // namespace stemware::pipeline
