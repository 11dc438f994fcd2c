#pragma once

#include "fem/pipeline/document/document.h"
#include "fem/pipeline/report/render/report.h"

#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace stemware::pipeline
{

/// A file of the results folder.
struct ResultFile
{
  std::string name; ///< relative to the results folder; .csv decides for CSV, anything else for a data table
  std::string description; ///< in the report's list of files; empty: not listed there
  /// A table, a text as it stands, or nothing for a file that is written elsewhere.
  Content content = {};
};

/// A part of what the console shows: a text, whose long lines are wrapped, and a table.
struct ConsoleBlock
{
  std::string text;
  std::optional<Table> table = {};
};

/// Everything that a verb has found out, as data to be rendered.
struct Results
{
  Report report;
  std::vector<ResultFile> files;
  std::vector<ConsoleBlock> console;
  std::vector<fem::FieldFile> fields = {}; ///< for fields/, those that this rank writes
  Findings findings;                       ///< for summary.json and --json
};

/// The blocks, an empty line before each and after the last.
std::string console_text(const Results &results);

} // namespace stemware::pipeline
