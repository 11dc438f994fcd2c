#pragma once

#include "fem/pipeline/analysis/comparison.h"
#include "fem/pipeline/output/publish.h"

#include <string>

namespace stemware::pipeline
{

/// All rows, a record each (csv_record()), units in the header; what does not exist is empty.
std::string comparison_csv(const Comparison &comparison);

/// "effects" (the key figures) and "comparison" of summary.json, one object for each row.
Findings comparison_findings(const Comparison &comparison);

/// What the harmonics do to the terminal spin, beside what the paper's balance of moments leaves out.
std::string comparison_answer(const Comparison &comparison);

/// "elastic foot, n <= 2", with @p at_most for the sign.
std::string load_title(const ComparisonRow &row, const std::string &at_most);

/// The terminal spins for the console: loads and truncations by closures, and why some do not exist.
std::string comparison_text(const Comparison &comparison);

/// "3", or "all".
std::string harmonics_name(const ComparisonRow &row);

} // namespace stemware::pipeline
