#pragma once

#include "fem/pipeline/analysis/spin_study.h"

#include <memory>
#include <vector>

namespace stemware::pipeline
{

/// The answer of a study by the number of harmonics: in balance where loads are two-way, else of the load of
/// rest, cut off.
struct TruncationStudy
{
  std::vector<double> omega; ///< spins at which SpinRow::torques are shown [rad/s]
  std::vector<double> time;  ///< of SpinRow::spin_up [s]
  std::vector<double> paper; ///< omega(t) of the paper's model [rad/s]
  double torque_slope = 0;   ///< d tau_z / d omega of all harmonics at their terminal spin [N m s]
  std::vector<SpinRow> rows; ///< rows_by_harmonics(), with torques and spin-ups
  TorqueCurve torque;        ///< of 1, 2, 3 and all harmonics
  HarmonicEffect harmonics;
  std::vector<BudgetRow> budget; ///< budget_rows(), of the same rows

  const SpinRow &all() const { return rows.back(); }
};

/// Solves for everything. @p omega: spins at which the torque is wanted [rad/s]; empty: half the terminal
/// spin of all harmonics, and that spin. @p foot is study_foot(), @p load find_load() of it. Throws as
/// rows_by_harmonics().
TruncationStudy study_truncations(const Study &study, const std::shared_ptr<ElasticFoot> &foot,
                                  const BalancedLoad &load, std::vector<double> omega,
                                  const Executor &executor, Progress &progress = silent_progress());

} // namespace stemware::pipeline
