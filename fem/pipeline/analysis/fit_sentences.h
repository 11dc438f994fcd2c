#pragma once

#include "fem/pipeline/analysis/fit.h"
#include "fem/pipeline/analysis/fit_problem.h"

#include <vector>

namespace stemware::pipeline
{

/// Returns what the data do not determine, which run would, and what the errors leave out; @p result: a fit
/// of
/// @p parameters, complete but for its sentences.
std::vector<FitSentence> fit_sentences(const std::vector<FitParameter> &parameters, const FitResult &result);

} // namespace stemware::pipeline
