#pragma once

#include "fem/pipeline/pictures/spin_rows.h"

/// Rows of terminal spins and of the budget for display, without rounding errors.
namespace stemware::pipeline
{

/// Returns chain_rows() for display: rows without effect are omitted, differences below 1e-9 v/R are 0, and
/// terminal spins have the digits supported by the band of the last row.
nlohmann::ordered_json shown_chain(const Study &study, std::vector<BudgetRow> rows);

/// Returns "budget" of summary.json; "harmonics" is "all" if none are omitted, "torques" is omitted if no row
/// has any.
nlohmann::ordered_json budget_summary(const Study &study, const std::vector<BudgetRow> &rows);

} // namespace stemware::pipeline
