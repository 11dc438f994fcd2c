#pragma once

#include "fem/pipeline/analysis/refinement_study.h"
#include "fem/pipeline/analysis/study_answer.h"
#include "fem/pipeline/analysis/sweep_case.h"
#include "fem/pipeline/result/results.h"

#include <string>
#include <vector>

/// Results of the verbs, and the JSON Schemas of their summaries.
namespace stemware::pipeline
{

/// Returns the results of `run`, without the fields, which the caller adds to avoid a copy.
Results run_results(const StudyAnswer &answer);

/// Returns the results of `truncate`: a part of those of `run`, with Depth::rows.
Results truncation_results(const StudyAnswer &answer);

/// Returns the results of `converge` from the solved @p axes and their total @p bands.
Results convergence_results(const Study &study, const std::vector<RefinementAxis> &axes,
                            const ErrorBands &bands);
Json converge_schema();

/// Returns converge.csv: the quantities of @p bands on every level of the axes.
Table level_table(const std::vector<RefinementAxis> &axes, const ErrorBands &bands);

/// Returns the results of `sweep` except sweep.csv: ranges of spin and harmonic effect, failures, and curves
/// or maps of a grid. Cases that are not @p finished are left out.
Results sweep_results(const CaseList &list, const FinishedCases &finished);
Json sweep_schema();

/// Returns summary.schema.json: the JSON Schema of the summaries of all verbs, and under "definitions/files"
/// key, heading without unit (name), unit and description (label) of the columns of data files.
std::string summary_schema();

/// Returns the unit of @p key in @p part of the summary, or in its entries if it is a list, or in
/// "sweep.csv"; empty for words.
std::string unit_in_summary(const std::string &part, const std::string &key);

} // namespace stemware::pipeline
