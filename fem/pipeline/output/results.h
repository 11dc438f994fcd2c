#pragma once

#include "fem/pipeline/output/publish.h"
#include "fem/pipeline/output/render/report.h"
#include "fem/pipeline/output/render/table.h"

#include <filesystem>
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
  std::variant<std::monostate, Table, std::string> content = {};
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
  Findings findings; ///< for publish()
};

/// The "Files" at the end of a report: those of @p files that have a description.
ReportSection file_section(const std::vector<ResultFile> &files);

/// Writes the files with content, then report.html and its plots, into @p folder. Ends the stages "tables"
/// and "report" of @p stopwatch. Throws OutputFailure. One rank only.
void write_results(const Results &results, const std::filesystem::path &folder, Stopwatch &stopwatch);

/// The blocks, an empty line before each and after the last.
std::string console_text(const Results &results);

} // namespace stemware::pipeline
