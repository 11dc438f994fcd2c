#pragma once

#include "fem/pipeline/analysis/study_result.h"
#include "fem/pipeline/output/publish.h"

namespace stemware::pipeline
{

/// A load at rest: "load" of summary.json.
nlohmann::ordered_json load_summary(const RingLoad &load);

/// What `run` adds to summary.json: load, contact (null without one), ring, resolved friction, truncation,
/// closures; and its key figures.
Findings run_findings(const Study &study, const StudyResult &result);

} // namespace stemware::pipeline
