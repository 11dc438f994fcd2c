#pragma once

#include "fem/pipeline/output/render/report.h"
#include "fem/pipeline/study/study.h"

namespace stemware::pipeline
{

/// What was asked for, for the end of any verb's report: the entries that differ from the defaults, and all
/// of them in a folded section.
std::vector<ReportSection> study_sections(const Study &study);

} // namespace stemware::pipeline
