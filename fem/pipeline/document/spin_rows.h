#pragma once

#include "fem/pipeline/analysis/spin_row.h"
#include "fem/pipeline/document/json.h"

#include <vector>

namespace stemware::pipeline
{

/// All numbers of the rows of run, truncate and compare, of which each shows some, by the keys of
/// summary.schema.json.
nlohmann::ordered_json spin_rows(const std::vector<SpinRow> &rows);

/// spin_rows() for people, who read 0 where a change of spin is below 1e-11 and a torque below 1e-12 of the
/// last row's at rest.
nlohmann::ordered_json shown_spin_rows(const std::vector<SpinRow> &rows);

/// a_n and b_n [N/rad] of a load, as two lists.
nlohmann::ordered_json series_summary(const ring::RingStack &load);

} // namespace stemware::pipeline
