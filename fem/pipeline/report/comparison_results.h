#pragma once

#include "fem/pipeline/analysis/comparison.h"
#include "fem/pipeline/report/head.h"
#include "fem/pipeline/report/results.h"

namespace stemware::pipeline
{

/// Adds to @p document what a verb shows beside the rows of its variants; returns the glasses to be drawn on
/// their orbits.
using ShownBeside = std::vector<TurningGlass> (*)(const Study &study, const Comparison &comparison,
                                                  Document &document);

/// The results of a verb that compares variants of a study, by the template of its name: "comparison" of
/// summary.json, the rows for people as "rows", what it shows beside them, if anything, and the study, with a
/// glass for each row of all harmonics where nothing else is to be drawn.
Results tabulate(const std::string &verb, const Study &study, const Comparison &comparison,
                 ShownBeside add_own = nullptr);

/// Adds what `compare` shows beside its rows: loads and truncations down, moment balances along, their plots,
/// the sentences of its answer and the budget; the glasses are the complete one and the paper's.
std::vector<TurningGlass> add_models(const Study &study, const Comparison &comparison, Document &document);

} // namespace stemware::pipeline
