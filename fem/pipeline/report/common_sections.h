#pragma once

#include "fem/pipeline/analysis/budget.h"
#include "fem/pipeline/analysis/refinement/quantities_of_interest.h"
#include "fem/pipeline/coupling/contact_report.h"
#include "fem/pipeline/report/document.h"
#include "fem/pipeline/study/study.h"

#include <nlohmann/json.hpp>

#include <vector>

/// Tables and sections that several verbs show.
namespace stemware::pipeline
{

/// What the template "study" shows: the entries of the study that differ from the defaults, and all of them.
void add_study(const Study &study, Document &document);

/// The end of a report: the entries of the study that differ from the defaults, all of them in a folded
/// section, and the files.
void add_closing_sections(Report &report, const Study &study, const std::vector<ResultFile> &files);

/// The load where it was solved, to be drawn instead of a series that overshoots; nothing without lift-off.
std::vector<fem::AzimuthLoad> drawn_pointwise(const LoadReport &load);

/// The chain of models of a budget on the console.
ConsoleBlock chain_block(const Study &study, const Budget &budget);

/// The chain of models of a budget that has nothing else, in a report; it must have a row.
ReportSection chain_section(const Study &study, const Budget &budget);

/// Says in the plots of a report that the load of rest is kept at every spin; those of the load itself stay.
void say_one_way(Report &report);

/// Bands of the amplitudes sqrt(a_n^2 + b_n^2) / a_0, n = 0 ... @p n_harmonics, as harmonics_table() and
/// spectrum_plot() take them: 0 beyond the harmonics that are followed; empty without bands.
std::vector<double> spectrum_band(const ErrorBands &bands, unsigned int n_harmonics);

/// The first harmonics of a load over its mean; those that are smaller than their error band @p band, by n as
/// in spectrum_plot(), are left out.
Table harmonics_table(const ring::RingStack &load, const std::vector<double> &band = {});

/// "load" and "load_at_terminal" of summary.json: a_n and b_n of each ring beside its radius and of their
/// sum.
nlohmann::ordered_json load_summary(const LoadReport &load);

/// a_n and b_n [N/rad] of a load, as two lists.
nlohmann::ordered_json series_summary(const ring::RingStack &load);

/// Quantities of interest with their error bands and Richardson values.
Table band_table(const std::vector<BandedQuantity> &bands);

/// "error_bands" of summary.json: value, half-width, what it is made of (null where a part was not estimated)
/// and unit of each quantity.
nlohmann::ordered_json band_summary(const std::vector<BandedQuantity> &bands);

/// What the discretisation leaves open, as a section of a report.
ReportSection error_band_section(const std::vector<BandedQuantity> &bands);

} // namespace stemware::pipeline
