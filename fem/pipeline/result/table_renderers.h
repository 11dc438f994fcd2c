#pragma once

#include "fem/pipeline/analysis/quantity.h"

#include <string>

/// Tables as text.
namespace stemware::pipeline
{

/// Returns a table of one row as a list: a row per column, with heading, unit, and value as text.
Table as_list(const Table &row);

/// Returns the table as text for numpy: "# title", a line "# 1: name (unit)" per column, then aligned rows of
/// full-precision numbers; flags are 1 and 0, missing values nan.
std::string data_table(const Table &table);

/// Returns a CSV file by RFC 4180 (commas, CRLF) with header "name (unit)" and full-precision numbers.
std::string csv_table(const Table &table);

/// Returns a table for the console: title, labels with units, rows. Columns that do not fit follow below,
/// with the first column repeated. Words are left-aligned, numbers right-aligned.
std::string console_table(const Table &table);

} // namespace stemware::pipeline
