#pragma once

#include "fem/pipeline/base/output.h"
#include "fem/pipeline/base/stopwatch.h"
#include "fem/pipeline/result/results.h"
#include "fem/pipeline/study/study_options.h"

namespace stemware::pipeline
{

/// Returns summary.json of a verb without "files": "schema", "program", "verb", "parameters" and the summary
/// of @p results. Throws std::runtime_error for a number that is not finite, which JSON cannot represent.
Json summary_of(const std::string &verb, const Results &results);

/// Publishes the results of a verb; collective. Each rank writes its fields into the working folder, the
/// first rank all other files: the files with content, parameters.prm, report.html, summary.json
/// (summary_of() and "files") and timings.json. The first rank then renames the folder and prints the
/// console's text and the location; with --json the last line of standard output is {"verb", "results",
/// "summary", "report", key figures}. Throws OutputFailure, and as summary_of().
void publish(const StudyOptions &options, Results results, ResultsFolder &folder, Stopwatch &stopwatch);

/// Writes the same files into the existing @p folder of a sweep, whose rows are written; on one rank.
void publish_in(const std::filesystem::path &folder, const StudyOptions &options, Results results,
                Stopwatch &stopwatch);

} // namespace stemware::pipeline
