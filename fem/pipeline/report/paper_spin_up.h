#pragma once

#include "fem/pipeline/report/figures.h"
#include "fem/pipeline/study.h"

namespace stemware::pipeline
{

/// The paper's own result for the glass of a study: its balance of moments, its load.
SpinUp paper_spin_up(const Study &study);

} // namespace stemware::pipeline
