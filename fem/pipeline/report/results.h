#pragma once

#include "fem/contact/foot.h"
#include "fem/pipeline/report/render/report.h"
#include "fem/pipeline/report/render/table.h"
#include "fem/pipeline/support/stopwatch.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace stemware::pipeline
{

/// Findings of a verb as programs read them. SI units, or those of the study.
struct Findings
{
  /// The verb's own parts of summary.json, which stand between "parameters" and "files".
  nlohmann::ordered_json summary = nlohmann::ordered_json::object();
  /// The few numbers of the last line of --json.
  nlohmann::ordered_json key_figures = nlohmann::ordered_json::object();
};

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

/// The "Files" at the end of a report: those of @p files that have a description.
ReportSection file_section(const std::vector<ResultFile> &files);

/// Writes @p fields into fields/ of @p folder, which all ranks see. Throws OutputFailure.
void write_fields(const std::vector<fem::FieldFile> &fields, const std::filesystem::path &folder);

/// Writes the files with content, then report.html and its plots, into @p folder. Ends the stages "tables"
/// and "report" of @p stopwatch. Throws OutputFailure. One rank only.
void write_results(const Results &results, const std::filesystem::path &folder, Stopwatch &stopwatch);

/// The blocks, an empty line before each and after the last.
std::string console_text(const Results &results);

} // namespace stemware::pipeline
