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

/// The load at rest: its plots, its tables and its files.
void add_load(const Study &study, const LoadReport &load, const ErrorBands &bands, Document &document);

/// Adds the chain of models for the templates "chain" and "chain_on_console": row by row and with its rows of
/// harmonics as one, and its plots.
void add_chain(const Study &study, const Budget &budget, Document &document);

/// Adds the tables for the template "error_bands".
void add_bands(const std::vector<BandedQuantity> &bands, Document &document);

/// "load" and "load_at_terminal" of summary.json: a_n and b_n of each ring beside its radius and of their
/// sum.
nlohmann::ordered_json load_summary(const LoadReport &load);

/// Quantities of interest with their error bands and Richardson values, for people.
nlohmann::ordered_json band_rows(const std::vector<BandedQuantity> &bands);

/// "error_bands" of summary.json: value, half-width, what it is made of (null where a part was not estimated)
/// and unit of each quantity.
nlohmann::ordered_json band_summary(const std::vector<BandedQuantity> &bands);

} // namespace stemware::pipeline
