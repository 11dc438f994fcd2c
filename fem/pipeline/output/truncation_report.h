#pragma once

#include "fem/pipeline/analysis/truncation_study.h"
#include "fem/pipeline/output/render/report.h"

namespace stemware::pipeline
{

/// The report of `truncate`: the answer, how fast the spin converges with the harmonics, both tables, the
/// load behind them, the study and the files.
Report truncation_report(const Study &study, const StudyLoad &load, const TruncationStudy &result);

} // namespace stemware::pipeline
