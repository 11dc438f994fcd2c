#pragma once

#include "fem/pipeline/study/study.h"
#include "fem/pipeline/study/study_options.h"
#include "fem/pipeline/support/shared_folder.h"
#include "fem/pipeline/support/stopwatch.h"

#include <nlohmann/json.hpp>

#include <optional>

namespace stemware::pipeline
{

/// A number of summary.json, or null where there is none.
inline nlohmann::ordered_json number_or_null(const std::optional<double> &value)
{
  return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json(nullptr);
}

/// What a verb has found out, as programs read it. SI units, or those of the study.
struct Findings
{
  /// The verb's own parts of summary.json, which stand between "parameters" and "files".
  nlohmann::ordered_json summary = nlohmann::ordered_json::object();
  /// The few numbers of the last line of --json.
  nlohmann::ordered_json key_figures = nlohmann::ordered_json::object();
};

/// The end of every verb, when its tables and report are in the working folder: writes parameters.prm,
/// summary.json ("schema", "program", "verb", "parameters", the findings, "files"), timings.json and
/// manifest.json, gives the folder its final name, and says where the results are. With --json the last line
/// of standard output is
/// {"verb", "results", "summary", "report" (null without a report.html), key figures}. Without a study there
/// is neither parameters.prm nor "parameters".
///
/// Collective over all ranks. Throws OutputFailure, and std::runtime_error for a finding that is not finite:
/// JSON has no word for it.
void publish(const StudyOptions &options, const std::optional<Study> &study, const Findings &findings,
             SharedFolder &folder, Stopwatch &stopwatch);

} // namespace stemware::pipeline
