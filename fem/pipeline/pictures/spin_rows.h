#pragma once

#include "fem/pipeline/analysis/budget.h"
#include "fem/pipeline/study/study.h"
#include "fem/pipeline/support/json.h"
#include "ring_model/spin/answer.h"
#include "ring_model/spin/torque_effect.h"

#include <string>
#include <vector>

/// Rows of terminal spins and the budget of effects in numbers, by the keys of summary.schema.json: for
/// summary.json, data files and pages.
namespace stemware::pipeline
{

/// Returns all numbers of the rows of run and truncate.
nlohmann::ordered_json spin_rows(const std::vector<ring::Answer> &rows);

/// Returns "truncation" of summary.json with further keys for tables: the numbers of @p rows, and for each
/// number of harmonics the effect on tau_z of friction. Numbers of harmonics without an answer in @p rows
/// have no spin. @p scale: spin_scale().
nlohmann::ordered_json truncation_rows(const std::vector<ring::Answer> &rows,
                                       const ring::TorqueEffects &effects, double scale);

/// Returns "torque_effect" of summary.json, the effect of all harmonics; null without harmonics beyond the
/// first.
nlohmann::ordered_json torque_effect_summary(const ring::TorqueEffects &effects);

/// Returns "fall" of summary.json: null without a fall, else its spin and moment ratio.
nlohmann::ordered_json fall_summary(const ring::Answer &all);

/// Returns a_n and b_n [N/rad] of a load as two lists.
nlohmann::ordered_json series_summary(const ring::RingStack &load);

// ---- the budget

/// Returns the label of a step of the chain: "1", "1a", "2", "2a", "3", "3a", "4", ...
std::string label_of(const ChainStep &step);

/// Returns the title of a row of the budget: "the paper's model", "moment balance", "harmonics, n ≤ 2",
/// "harmonics, all"; @p at_most replaces the sign "≤".
std::string title_of(const BudgetRow &row, const std::string &at_most = "≤");

/// Returns the chain of models by row: added effect, number of harmonics, terminal spin, difference to the
/// row above in rad/s and relative, and tau_z at 0, half and all of the complete model's terminal spin.
/// Differences relative to a spin of zero are null.
nlohmann::ordered_json chain_rows(const Study &study, const std::vector<BudgetRow> &rows);

/// Returns the chain with its rows of harmonics merged into one, from the first harmonic to all.
std::vector<BudgetRow> named_steps(const std::vector<BudgetRow> &rows);

/// Returns the complete model without one effect at a time, compared with the complete model.
nlohmann::ordered_json without_rows(const Study &study, const Budget &budget);

/// Returns "harmonic_effect" of summary.json: absolute [rad/s] and relative.
nlohmann::ordered_json harmonic_effect_summary(const HarmonicEffect &effect);

/// Returns whether a spin exceeds rounding_of_spins().
bool is_spin(const Study &study, double omega);

} // namespace stemware::pipeline
