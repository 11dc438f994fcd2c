#pragma once

#include "fem/pipeline/analysis/fit.h"
#include "fem/pipeline/pictures/pictures.h"

#include <nlohmann/json.hpp>

namespace stemware::pipeline
{

/// Returns summary.json/fit.
nlohmann::ordered_json fit_summary(const FitResult &found);

/// Adds "fit_of_run_1" and so on: measured and fitted points; "fit_ellipse_1_2" and so on: within it lie the
/// first and the second entry with 95 %; and the word "fit_sentences": key, text and values of each.
void add_fit_columns(const FitResult &found, Pictures &pictures);

} // namespace stemware::pipeline
