#pragma once

#include "fem/pipeline/study/study.h"

#include <vector>

namespace stemware::pipeline
{

/// omega(t) [rad/s] of the paper's own model for the glass of a study, at the times of spin_up_curves(): its
/// balance of moments, its load.
std::vector<double> paper_spin_up(const Study &study);

} // namespace stemware::pipeline
