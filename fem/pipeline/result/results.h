#pragma once

#include "fem/contact/foot.h"
#include "fem/pipeline/analysis/quantity.h"
#include "fem/pipeline/study/study.h"

#include <string>
#include <variant>
#include <vector>

namespace stemware::pipeline
{

/// File of the results folder.
struct ResultFile
{
  std::string name;        ///< path relative to the results folder
  std::string description; ///< description in the page's list of files; empty: not listed
  /// Table of a CSV file, or text; std::monostate for a file written elsewhere.
  std::variant<std::monostate, Table, std::string> content = {};
};

/// Results of a verb in SI units, for summary.json, --json, page, console and files.
struct Results
{
  Study study = {};                  ///< solved study
  Json summary = Json::object();     ///< parts of summary.json that depend on the verb
  Json key_figures = Json::object(); ///< key figures in the last line of --json
  Json words = Json::object();       ///< texts by name, among them "title", "inputs" and "answer"
  /// Columns of tables and pictures by name: {"keys": [...], "values": [[...] ...]}.
  Json tables = Json::object();
  Json quantities = Json::object(); ///< heading, unit and digits of the columns, by table and key
  Json entries = Json::array();     ///< all entries of the study
  std::vector<ResultFile> files = {};
  /// Console output: texts, whose long lines are wrapped, and tables.
  std::vector<std::variant<std::string, Table>> console = {};
  std::vector<fem::FieldFile> fields = {}; ///< files of fields/ written by this rank

  /// Adds a table to the page; with Face::picture, the numbers of a picture, rounded to six digits.
  void add_table(const std::string &name, const Table &table, Face face = Face::page);
};

/// Returns a number rounded to @p n_digits significant digits; null if it is not finite.
Json rounded_number(double value, int n_digits = 6);
Json rounded_number(const std::vector<double> &values, int n_digits = 6);

/// Returns the text of the console: all parts, with an empty line before each and after the last.
std::string console_text(const Results &results);

// ---- tables as text

/// Returns a table of one row as a list: a row per column with a value, with heading, unit, and value as
/// text.
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
