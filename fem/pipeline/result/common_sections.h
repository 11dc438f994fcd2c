#pragma once

#include "fem/pipeline/analysis/quantities_of_interest.h"
#include "fem/pipeline/analysis/ring_quantities.h"
#include "fem/pipeline/analysis/study_answer.h"
#include "fem/pipeline/result/results.h"

#include <string>
#include <vector>

/// Parts of summary.json, tables and data files of several verbs.
namespace stemware::pipeline
{

/// Returns "error_bands" of summary.json, by key; @p with_richardson: with the extrapolated value.
Fields<BandedQuantity> band_fields(bool with_richardson);

/// Returns "load", "harmonic_effect", "torque_effect" and "truncation" of summary.json.
Fields<StudyAnswer> harmonics_fields();

/// Returns the summaries of `run` and `truncate`.
Fields<StudyAnswer> run_fields();
Fields<StudyAnswer> truncate_fields();

/// Returns "contact" of summary.json, and the page's numbers of the contact.
Fields<FootReport> contact_fields();

/// Adds the table "truncations" and the picture "torque_changes".
void add_truncations(const StudyAnswer &answer, Results &results);

/// Adds the tables "bands" and "band_parts".
void add_band_tables(const std::vector<BandedQuantity> &bands, Results &results);

/// Returns the files of `run`, with the tables that the answer has.
std::vector<ResultFile> run_files(const StudyAnswer &answer);

/// Returns the Fourier coefficients of a load, summed over its rings, for read_load_file(), with further
/// columns: amplitude over a_0, direction of the crest.
std::string load_file_text(const ring::RingStack &load);

} // namespace stemware::pipeline
