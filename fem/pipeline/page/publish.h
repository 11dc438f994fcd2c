#pragma once

#include "fem/pipeline/report/results.h"
#include "fem/pipeline/study/study.h"
#include "fem/pipeline/study/study_options.h"
#include "fem/pipeline/support/output.h"
#include "fem/pipeline/support/stopwatch.h"

#include <optional>

namespace stemware::pipeline
{

/// Document of a verb, summary.json without "files": "schema", "program", "verb", "parameters", the @p
/// findings. Throws std::runtime_error for a finding that is not finite: JSON has no word for it.
nlohmann::ordered_json summary_of(const std::string &verb, const std::optional<Study> &study,
                                  const Findings &findings);

/// The end of every verb, collective over all ranks: each writes its fields of @p results into the working
/// folder, the first all else: the files with content and report.html. When all have, that one
/// writes parameters.prm, summary.json ("schema", "program", "verb", "parameters", the findings, "files"),
/// timings.json, gives the folder its final name, and prints the console's text and where
/// the results are. With --json the last line of standard output is {"verb", "results", "summary", "report",
/// key figures}. Without a study there is neither parameters.prm nor "parameters".
///
/// Throws OutputFailure, and std::runtime_error for a finding that is not finite: JSON has no word for it.
void publish(const StudyOptions &options, const std::optional<Study> &study, Results results,
             ResultsFolder &folder, Stopwatch &stopwatch);

/// Writes the same into @p folder as it stands, on one rank: for a sweep, whose rows are in it already.
void publish_in(const std::filesystem::path &folder, const StudyOptions &options,
                const std::optional<Study> &study, const Results &results, Stopwatch &stopwatch);

} // namespace stemware::pipeline
