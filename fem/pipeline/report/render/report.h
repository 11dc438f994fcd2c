#pragma once

#include "fem/pipeline/document/table.h"
#include "fem/pipeline/report/plot.h"

#include <filesystem>
#include <string>
#include <vector>

namespace stemware::pipeline
{

/// A file of the results to which a report links.
struct FileNote
{
  std::string name; ///< relative to the results folder
  std::string description;
};

/// A heading, paragraphs (parted by empty lines), plots, tables and files, in this order; whatever is empty
/// is left out.
struct ReportSection
{
  std::string heading, text = "";
  std::vector<Plot> plots = {};
  std::vector<Table> tables = {};
  std::vector<FileNote> files = {};
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

/// Writes report.html, one page that needs nothing else (CSS and SVG inside, no address outside), and
/// figures/ with the plots as SVG and PDF, their gnuplot scripts and data, into @p folder.
///
/// Equal reports give equal files, byte for byte. What gnuplot does not draw is left out, and the page says
/// why: results are not lost for want of a picture. Where gnuplot fails, stderr says so too; that it is
/// missing, missing_plotter() has told in advance. Throws OutputFailure. One rank only.
void write_report(const Report &report, const std::filesystem::path &folder);

} // namespace stemware::pipeline
