#pragma once

#include "fem/pipeline/analysis/fit.h"
#include "fem/pipeline/report/results.h"

namespace stemware::pipeline
{

/// Results of `stemware fit`: summary.json has them as "fit".
Results tabulate_fit(const FitResult &found);

} // namespace stemware::pipeline
