#pragma once

#include "fem/pipeline/analysis/quantity.h"
#include "fem/pipeline/analysis/spin_study.h"
#include "fem/pipeline/coupling/balanced_load.h"
#include "fem/pipeline/study/study.h"
#include "ring_model/spin/answer.h"

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// Quantities of an answer, of the rows by harmonics, and of the budget.
namespace stemware::pipeline
{

/// Highest harmonic of the load among the quantities of a study.
constexpr unsigned int n_harmonics_of_interest = 8;

/// Returns "fall" of summary.json.
Fields<ring::RingState> fall_fields();

/// Returns the quantities of ring::Answer that are in "ring" of summary.json.
const Fields<ring::Answer> &answer_fields();

/// Returns "load" and "load_at_terminal" of summary.json.
const Fields<LoadReport> &load_fields();

/// Returns a_n and b_n [N/rad] of a load as two lists.
std::array<std::vector<double>, 2> series_of(const ring::RingStack &load);

// ---- rows by harmonics

/// Row of "truncation": answer with a number of harmonics, and their effect on tau_z of friction.
struct Truncation
{
  ring::Answer answer; ///< without a spin if unsolved
  ring::TorqueEffect effect;
  double torque_at_rest = 0;         ///< TorqueEffects::torque_at_rest
  std::optional<double> spin_change; ///< relative to the spin of the first harmonic only
};

/// Returns the rows of SpinStudy::torque_effects with their answers.
std::vector<Truncation> truncations_of(const SpinStudy &spin);

/// Returns the @p rows whose neglected harmonics change tau_z by more than 1e-9 of the torque at rest, and
/// the last row; values below rounding become 0.
std::vector<Truncation> shown_truncations(std::vector<Truncation> rows);

/// Returns "truncation" of summary.json and its tables.
Fields<Truncation> truncation_fields();

/// Returns "torque_effect" of summary.json, members of Truncation.
Fields<Truncation> torque_change_fields();

// ---- the budget

/// Returns the label of a step of the chain: "1", "1a", "2", "2a", "3", "3a", "4", ...
std::string label_of(const ChainStep &step);

/// Returns the title of a row of the budget: "moment balance", "harmonics, n ≤ 2"; @p at_most replaces "≤".
std::string title_of(const BudgetRow &row, const std::string &at_most = "≤");

/// Returns the quantities of a row of the budget. @p scale: Study::spin_scale(), for rounding to 0;
/// @p shown_spin: format of the terminal spin.
Fields<BudgetRow> chain_fields(double scale = 1, const std::function<Json(double)> &shown_spin = {});

/// Returns step, title and torques of a row of the budget, a table of the page.
Fields<BudgetRow> chain_torque_fields();

/// Returns the chain with one row for all its rows of harmonics.
std::vector<BudgetRow> named_steps(const std::vector<BudgetRow> &rows);

/// Returns the chain for display, without rows of no effect; spins and differences below @p rounding are 0.
std::vector<BudgetRow> shown_chain(const std::vector<BudgetRow> &rows, double rounding);

/// Returns the quantities of a changed input.
Fields<std::pair<std::string, double>> input_fields();

/// Returns the quantities of a model without one effect; @p complete: the study's terminal spin [rad/s].
Fields<WithoutRow> without_fields(const std::optional<double> &complete = {}, double scale = 1);

/// Returns "harmonic_effect" of summary.json.
Fields<HarmonicEffect> harmonic_effect_fields();

/// Returns @p value, or 0 if |value| is below @p rounding.
double without_rounding(double value, double rounding);
void drop_rounding(std::optional<double> &value, double rounding);

} // namespace stemware::pipeline
