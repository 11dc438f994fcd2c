#pragma once

#include "fem/pipeline/analysis/refinement/quantities_of_interest.h"
#include "fem/pipeline/coupling/contact_report.h"
#include "fem/pipeline/output/results.h"
#include "fem/pipeline/study/study.h"

#include <nlohmann/json.hpp>

#include <vector>

/// Tables and sections that several verbs show.
namespace stemware::pipeline
{

/// The end of a report: the entries of the study that differ from the defaults, all of them in a folded
/// section, and the files.
void add_closing_sections(Report &report, const Study &study, const std::vector<ResultFile> &files);

/// The first harmonics of a load over its mean.
Table harmonics_table(const ring::RingStack &load);

/// "load" of summary.json: a load at rest.
nlohmann::ordered_json load_summary(const LoadReport &load);

/// a_n and b_n [N/rad] of a load, as two lists.
nlohmann::ordered_json series_summary(const ring::RingStack &load);

/// Quantities of interest with their error bands and Richardson values.
Table band_table(const std::vector<BandedQuantity> &bands);

/// What the discretisation leaves open, as a section of a report.
ReportSection error_band_section(const std::vector<BandedQuantity> &bands);

} // namespace stemware::pipeline
