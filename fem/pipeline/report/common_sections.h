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

/// Adds the entries of the study for the template "study": those that are not the defaults, and all of them.
void add_study(const Study &study, Document &document);

/// The load at rest: its plots, its tables and its files.
void add_load(const Study &study, const LoadReport &load, const ErrorBands &bands, Document &document);

/// Adds the chain of models for the templates "chain" and "chain_on_console": row by row and with its rows of
/// harmonics as one, and its plots.
void add_chain(const Study &study, const Budget &budget, Document &document);

/// Adds the tables for the template "error_bands".
void add_bands(const std::vector<BandedQuantity> &bands, Document &document);

/// Bands of the amplitudes sqrt(a_n^2 + b_n^2) / a_0, n = 0 ... @p n_harmonics, as harmonics_table() and
/// add_load_plots() take them: 0 beyond the harmonics that are followed; empty without bands.
std::vector<double> spectrum_band(const ErrorBands &bands, unsigned int n_harmonics);

/// The first harmonics of a load over its mean; those that are smaller than their error band @p band, by n as
/// in add_load_plots(), are left out.
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

} // namespace stemware::pipeline
