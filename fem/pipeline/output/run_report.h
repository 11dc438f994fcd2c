#pragma once

#include "fem/pipeline/analysis/study_result.h"
#include "fem/pipeline/output/render/report.h"

namespace stemware::pipeline
{

/// The report of `run`: the answer, and behind it the load, the torque, the spin-up, the truncations, the
/// closures, the contact, the study and the files, those in @p folder where some may be missing.
Report run_report(const Study &study, const StudyResult &result, const std::filesystem::path &folder);

} // namespace stemware::pipeline
