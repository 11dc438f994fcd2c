#pragma once

#include "fem/pipeline/analysis/spin_study.h"
#include "fem/pipeline/coupling/elastic_foot.h"

#include <optional>
#include <string>
#include <vector>

namespace stemware::pipeline
{

/// Rows by the number of harmonics, with what is drawn about them.
struct TruncationTable
{
  std::vector<SpinRow> rows; ///< 1, 2, 3, 4, 6, 8, 12, ... and all, which is the last
  TorqueCurve torque; ///< from rest to beyond the terminal spins, 1, 2, 3 and all; NaN without a balance

  const SpinRow &all() const { return rows.back(); }
};

/// The answer of a study by the number of harmonics, both ways of leaving some out.
struct TruncationStudy
{
  std::vector<double> omega; ///< spins at which SpinRow::torques are shown [rad/s]
  std::vector<double> time;  ///< of SpinRow::spin_up [s]
  std::vector<double> paper; ///< omega(t) of the paper's model [rad/s]
  double torque_slope = 0;   ///< d tau_z / d omega of the study's own load at its terminal spin [N m s]
  /// The load of all harmonics, at rest or in balance at every spin as the study has it, is cut off; neither
  /// contact nor friction is solved again.
  TruncationTable frozen;
  /// The contact is in balance with the friction of its own load, cut off, at every spin.
  std::optional<TruncationTable> self_consistent;
  std::string why_not;         ///< one sentence where there is no such balance
  bool acts_back = true;       ///< false: the moment balance lets no friction act back, so both tables agree
  bool same_whole_load = true; ///< whether all harmonics are one load in both tables, not that of rest in one
  std::vector<SpinRow> closures; ///< as SpinStudy::closures
};

/// Solves for everything. @p omega: spins at which the torque is wanted [rad/s]; empty: half the terminal
/// spin of all harmonics, and that spin. @p foot is the study's, nothing where the load does not come from a
/// contact. Throws std::runtime_error where all harmonics have no terminal spin.
TruncationStudy study_truncations(const Study &study, const std::shared_ptr<ElasticFoot> &foot,
                                  const BalancedLoad &load, std::vector<double> omega, Progress &progress);

} // namespace stemware::pipeline
