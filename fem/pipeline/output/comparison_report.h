#pragma once

#include "fem/pipeline/analysis/comparison.h"
#include "fem/pipeline/output/render/report.h"

namespace stemware::pipeline
{

/// The report of `compare`: the answer, a picture of the terminal spins, the tables of the closures, the
/// study and the files.
Report comparison_report(const Study &study, const Comparison &comparison);

} // namespace stemware::pipeline
