#pragma once

#include "fem/contact/foot.h"
#include "fem/pipeline/analysis/quantity.h"
#include "fem/pipeline/study/study.h"

#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace stemware::pipeline
{

/// File of the results folder.
struct ResultFile
{
  /// Path relative to the results folder; .csv for a CSV file, any other extension for a data table.
  std::string name;
  std::string description; ///< description in the page's list of files; empty: not listed
  /// Table or text; std::monostate for a file written elsewhere.
  std::variant<std::monostate, Table, std::string> content = {};
};

/// Part of the console output: a text, whose long lines are wrapped, and a table.
struct ConsoleBlock
{
  std::string text;
  std::optional<Table> table = {};
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
  std::vector<ConsoleBlock> console = {};
  std::vector<fem::FieldFile> fields = {}; ///< files of fields/ written by this rank

  /// Adds a table to the page.
  void add_table(const std::string &name, const Table &table);

  /// Adds columns of numbers for a picture, with six digits.
  void add_columns(const std::string &name,
                   const std::vector<std::pair<std::string, std::vector<double>>> &columns);
};

/// Returns a number rounded to @p n_digits significant digits; null if it is not finite.
Json rounded_number(double value, int n_digits = 6);
Json rounded_number(const std::vector<double> &values, int n_digits = 6);

/// Returns the text of the console: all blocks, with an empty line before each and after the last.
std::string console_text(const Results &results);

} // namespace stemware::pipeline
