#pragma once

#include "fem/pipeline/analysis/budget.h"
#include "fem/pipeline/document/json.h"
#include "fem/pipeline/study/study.h"
#include "ring_model/spin/answer.h"

#include <string>
#include <vector>

/// Rows of terminal spins and the budget of effects in numbers: for the console, reports, data files and
/// summary.json.
namespace stemware::pipeline
{

/// All numbers of the rows of run and truncate, of which each shows some, by the keys of
/// summary.schema.json.
nlohmann::ordered_json spin_rows(const std::vector<ring::Answer> &rows);

/// spin_rows() for people, who read 0 where a change of spin is below 1e-11 and a torque below 1e-12 of the
/// last row's at rest.
nlohmann::ordered_json shown_spin_rows(const std::vector<ring::Answer> &rows);

/// a_n and b_n [N/rad] of a load, as two lists.
nlohmann::ordered_json series_summary(const ring::RingStack &load);

// ---- the budget

/// The label of a place in the chain: "1", "1a", "2", "2a", "3", "3a", "4", ...
std::string label_of(const ChainStep &step);

/// Title of a row of the budget for people: "the paper's model", "moment balance", "harmonics, n ≤ 2",
/// "harmonics, all"; @p at_most stands for the sign "≤".
std::string title_of(const BudgetRow &row, const std::string &at_most = "≤");

/// The chain of models by row: what each adds, how many harmonics it keeps, its terminal spin and the
/// difference to the row above, in rad/s and relative, and tau_z at 0, half and all of the complete model's
/// terminal spin. Relative differences to a glass that does not spin do not exist.
nlohmann::ordered_json chain_rows(const Study &study, const std::vector<BudgetRow> &rows);

/// chain_rows() for people: without the numbers of harmonics that change nothing, 0 where a difference is
/// less than 1e-9 v/R, and terminal spins with the digits that the band of the last row leaves.
nlohmann::ordered_json shown_chain(const Study &study, std::vector<BudgetRow> rows);

/// The chain with its rows of harmonics as one, from the first harmonic to all of them.
std::vector<BudgetRow> named_steps(const std::vector<BudgetRow> &rows);

/// The complete model with one thing left out at a time, beside the complete model.
nlohmann::ordered_json without_rows(const Study &study, const Budget &budget);

/// "budget" of summary.json; "harmonics" is "all" where none are left out, "torques" is left away where no
/// row has any.
nlohmann::ordered_json budget_summary(const Study &study, const std::vector<BudgetRow> &rows);

/// "harmonic_effect" of summary.json: absolute [rad/s] and relative.
nlohmann::ordered_json harmonic_effect_summary(const HarmonicEffect &effect);

/// A spin that nothing is related to [rad/s]: 1e-9 v/R.
double rounding_of_spins(const Study &study);

/// True if a spin is more than rounding.
bool is_spin(const Study &study, double omega);

} // namespace stemware::pipeline
