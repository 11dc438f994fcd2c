#pragma once

#include "fem/pipeline/document/document.h"
#include "fem/pipeline/report/plot.h"

#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace stemware::pipeline
{

/// A file of the results folder, to which a report links.
struct ResultFile
{
  std::string name; ///< relative to the results folder; .csv decides for CSV, anything else for a data table
  std::string description; ///< in the report's list of files; empty: not listed there
  /// A table, a text as it stands, or nothing for a file that is written elsewhere.
  Content content = {};
};

/// A heading, paragraphs (parted by empty lines), plots, tables and files, in this order; whatever is empty
/// is left out.
struct ReportSection
{
  std::string heading, text = "";
  std::vector<Plot> plots = {};
  std::vector<Table> tables = {};
  std::vector<ResultFile> files = {};
  bool folded = false; ///< shown when the heading is clicked
};

/// The results of a verb as a page to be read. All texts are plain: they are escaped here and nowhere else,
/// and an underscore after a single letter makes a subscript (τ_z, a_n, z_CM).
struct Report
{
  std::string title;
  std::string answer; ///< first paragraph: one or two sentences with the numbers that were asked for
  std::vector<ReportSection> sections;
  std::string inputs = "";         ///< a line under the title: what was computed
  std::vector<Plot> pictures = {}; ///< between the inputs and the answer
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

/// Writes report.html, one page that needs nothing else (CSS and SVG inside, no address outside), and
/// figures/ with the plots as SVG and PDF, their gnuplot scripts and data, into @p folder.
///
/// Equal reports give equal files, byte for byte. What gnuplot does not draw is left out, and the page says
/// why: results are not lost for want of a picture. Where gnuplot fails, stderr says so too; that it is
/// missing, missing_plotter() has told in advance. Throws OutputFailure. One rank only.
void write_report(const Report &report, const std::filesystem::path &folder);

} // namespace stemware::pipeline
