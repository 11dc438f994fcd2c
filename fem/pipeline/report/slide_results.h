#pragma once

#include "fem/pipeline/analysis/slide.h"
#include "fem/pipeline/report/results.h"

namespace stemware::pipeline
{

/// The results of `slide`: where the body went, how it turned, and where its energy went.
Results tabulate(const Study &study, const SlideStudy &slide);

} // namespace stemware::pipeline
