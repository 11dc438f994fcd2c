#pragma once

#include "fem/pipeline/analysis/solve_study.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace stemware::pipeline
{

/// A load that is cut off may be negative somewhere: the table would have to pull.
struct NegativeLoad
{
  double minimum = 0;       ///< least value of the load [N/rad]
  double pulling_share = 0; ///< what the table would have to pull with, over N
};

/// The glass on a load that is cut off after some harmonics. What depends on a terminal spin is missing where
/// there is none.
struct TruncatedAnswer
{
  unsigned int harmonics = 0;
  double amplitude = 0;       ///< of the highest harmonic kept, sqrt(a_n^2 + b_n^2) / a_0 at rest
  double tau_at_rest = 0;     ///< tau_z(omega = 0) [N m]
  std::vector<double> torque; ///< tau_z at the chosen spins [N m]; NaN where the load has no balance there
  std::optional<double> omega_terminal;       ///< [rad/s]
  std::optional<double> relative_change;      ///< of omega_terminal to that of all harmonics
  std::optional<double> largest_deviation;    ///< of omega(t) from that of all harmonics, over all t [rad/s]
  std::optional<double> final_deviation;      ///< the same at the end of the spin-up [rad/s]
  std::optional<double> bound;                ///< a priori, see TruncationTable [N m]
  NegativeLoad at_rest;                       ///< of the load at rest
  std::optional<NegativeLoad> at_terminal;    ///< of the load at omega_terminal
  std::optional<ring::RingStack> load = {}; ///< at omega_terminal
  std::vector<double> spin_up;                ///< omega(t) [rad/s]; empty where it does not exist
  std::string trouble;                        ///< why something is missing; empty where nothing is

  /// Whether the load is negative somewhere, at rest or at the terminal spin.
  bool pulls() const;
  /// The worse of both loads.
  NegativeLoad worst() const;
};

/// Answers by the number of harmonics: 1, 2, 3, 4, 6, 8, 12, 16, 24 ... and all, which is the last.
///
/// The bounds are mu R sum_{n > n_max} |K_n| sqrt(a_n^2 + b_n^2) at the terminal spin of all harmonics: of
/// the change of tau_z when the harmonics above n_max are left out of the load that the contact answers the
/// same moment with.
struct TruncationTable
{
  std::vector<TruncatedAnswer> answers;
  TorqueCurve torque; ///< from rest to beyond the terminal spins, 1, 2, 3 and all; NaN without a balance
  const TruncatedAnswer &all() const { return answers.back(); }
};

/// The answer of a study by the number of harmonics, both ways of leaving some out.
struct TruncationStudy
{
  std::vector<double> omega; ///< spins at which the torque is shown [rad/s]
  std::vector<double> time;  ///< of the spin-ups [s]
  double torque_slope = 0;   ///< d tau_z / d omega of the study's own load at its terminal spin [N m s]
  /// The load of all harmonics, at rest or in balance at every spin as the study has it, is cut off; nothing
  /// answers to that.
  TruncationTable frozen;
  /// The contact is in balance with the friction of its own load, cut off, at every spin.
  std::optional<TruncationTable> self_consistent;
  std::string why_not;   ///< one sentence where there is no such balance
  bool acts_back = true; ///< false: the closure lets no friction act back, so both tables agree
  /// Half-width of the error band of the study's own terminal spin [rad/s], of the discretisation; nothing:
  /// not estimated.
  std::optional<double> spin_band;
  bool same_whole_load = true; ///< whether all harmonics are one load in both tables, not that of rest in one
  std::vector<ClosureRow> closures; ///< of a first harmonic
};

/// Told after each truncation how many are done.
using TruncationProgress = std::function<void(std::size_t n_done, std::size_t n_all)>;

/// Solves for everything. @p omega: spins at which the torque is wanted [rad/s]; empty: half the terminal
/// spin of all harmonics, and that spin. Throws std::runtime_error where all harmonics have no terminal spin.
TruncationStudy study_truncations(const Study &study, const StudyLoad &load, std::vector<double> omega,
                                  const TruncationProgress &progress = {});

} // namespace stemware::pipeline
