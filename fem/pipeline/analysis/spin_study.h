#pragma once

#include "fem/pipeline/analysis/budget.h"
#include "fem/pipeline/analysis/study_rows.h"
#include "fem/pipeline/coupling/driven_load.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace stemware::pipeline
{

/// The torques on the glass and the friction force over the spin; NaN where there is no balance.
struct TorqueCurve
{
  /// Spins from just before rest to beyond the terminal spins, or to the fall of the glass [rad/s].
  std::vector<double> omega;
  std::vector<double> slip_ratio;      ///< omega R / v
  std::vector<ring::Wrench> friction;  ///< of all harmonics
  std::vector<double> lean_torque;     ///< Torques::lean_torque of all harmonics [N m]
  std::vector<double> grip_torque;     ///< Torques::grip_torque of all harmonics [N m]
  std::vector<double> sum;             ///< tau_z, lean and grip torque: I d omega / dt of all harmonics [N m]
  std::vector<unsigned int> harmonics; ///< of the truncations
  std::vector<std::vector<double>> truncations; ///< tau_z [N m], [truncation][spin]

  /// v/R, beyond which part of the rim slides backwards [rad/s]; nothing where the curve does not tell.
  std::optional<double> spin_unit() const;
};

/// omega(t) from rest while the hand's speed changes.
struct DrivenSpinUp
{
  std::vector<double> time;         ///< [s]
  std::vector<double> speed;        ///< v(t) [m/s]
  std::vector<double> acceleration; ///< dv/dt [m/s^2]
  std::vector<double> omega;        ///< all harmonics, error control [rad/s]
  /// Change of omega where straight lines, and not the monotone cubic, join the file's entries, told by the
  /// first harmonic on a rigid rim in balance [rad/s].
  double interpolation_change = 0;         ///< at most, at any of the times
  double interpolation_change_at_end = 0;  ///< at the last one
  std::optional<Breakaway> breakaway = {}; ///< of a hand that starts from rest
};

/// omega(t) from rest at equally spaced times, each load in its own balance; NaN from where the glass falls
/// over.
struct SpinUpCurves
{
  std::vector<double> time;     ///< [s]
  std::vector<double> adaptive; ///< all harmonics, error control [rad/s]
  std::vector<double> euler;    ///< all harmonics, forward Euler as in the paper [rad/s]
  std::vector<double>
    first_harmonic;              ///< first harmonic alone, error control [rad/s]; empty without a balance
  std::vector<double> yaw_angle; ///< all harmonics, error control [rad]
  std::vector<double> paper; ///< the paper's model of the same glass: its moment balance, its load [rad/s]
  std::optional<DrivenSpinUp> driven = {}; ///< with the speeds of Motion/Orbit speed file, where there is one
};

/// Findings of a study of the spin that only a load which depends on the phase has.
struct PhaseStudy
{
  double spin_ripple = 0;         ///< half of largest minus smallest spin in the long run [rad/s]
  double spin_uncertainty = 0;    ///< of the mean spin in the long run, Answer::spin_uncertainty [rad/s]
  double zero_of_mean_torque = 0; ///< spin at which the torque vanishes on average over the phases [rad/s]
  double torque_ripple = 0; ///< half of largest minus smallest torque over the phases, at the mean spin [N m]
  double least_load = 0;    ///< pointwise, at rest, of all sampled phases [N/rad]
  double least_contact_fraction = 0; ///< at rest, of all sampled phases
  unsigned int n_glass_phases = 1;   ///< sampled
  unsigned int n_table_phases = 1;
  std::size_t n_spins = 1;        ///< sampled; 1 for a load that does not depend on the spin
  double interpolation_error = 0; ///< of the load between samples, torque_difference()

  /// Sampled phases: azimuths of the marks [rad], torque at rest and at the mean spin [N m].
  std::vector<ring::Orientation> phases;
  std::vector<double> torque_at_rest;
  std::vector<double> torque_at_terminal;
};

/// Spin that follows from a load, with all that is found out about it.
struct SpinStudy
{
  std::vector<ring::Answer> rows;       ///< by harmonics: rows_by_harmonics()
  std::optional<ring::Answer> one_ring; ///< all harmonics on one ring; nothing where the study has one
  Budget budget;                        ///< without rows where the answer alone was asked
  TorqueCurve torque;                   ///< of the first harmonic and of all
  SpinUpCurves spin_up;
  /// Answer::all_spins of the last row; empty where rim or table are wavy, or a torque takes minutes (a solid
  /// body in balance at every spin).
  std::vector<ring::TerminalSpin> terminal_spins;
  std::optional<PhaseStudy> phases; ///< nothing where rim and table are flat
  /// Error of the curves' load, which is interpolated in the spin, over a_0; nothing where it is exact.
  std::optional<double> curve_error = {};

  const ring::Answer &all() const { return rows.back(); }
  /// True if the answer and its curves were all that was asked: Depth::answer.
  bool is_quick() const { return budget.rows.empty(); }
  /// Returns false for a glass without a moment, whose terminal spin is zero to rounding.
  bool spins_up() const { return all().relative_change.has_value(); }
};

/// The spins of torque_curve(), lowest first: from a little before rest to half as far again as the fastest
/// terminal spin, or to where the glass falls over [rad/s].
std::vector<double> shown_spins(const Study &study, const std::vector<LoadedRow> &rows);

/// Curves of @p row at @p spins [rad/s] and over the time of the study, whose longest Euler step is @p
/// euler_step [s], 0 for none; @p all_spins if Answer::all_spins is wanted.
ring::Answer curves_of(const Study &study, const LoadedRow &row, const std::vector<double> &spins,
                       double euler_step = 0, bool all_spins = false);

/// The curves of the paper's own model for the glass of a study: its moment balance, its load.
ring::Answer paper_curves(const Study &study, const std::vector<double> &spins);

/// The torques of @p all at @p spins [rad/s], with those of @p first, an answer with fewer harmonics, if it
/// has any.
TorqueCurve torque_curve(const std::vector<double> &spins, double spin_scale, const ring::Answer &all,
                         const ring::Answer &first);

/// The spin-up with the speeds of Motion/Orbit speed file, contact in balance at every instant, at @p times;
/// nothing without such a file. @p foot is study_foot() with its rings chosen. Throws what the torque throws.
std::optional<DrivenSpinUp> driven_spin_up(const Study &study, const std::shared_ptr<ElasticFoot> &foot,
                                           const std::vector<double> &times);

/// Solves for everything, or with Depth::answer for the answer and its curves: neither a budget but the
/// effect of the harmonics, nor one ring. @p foot is study_foot(), @p load find_load() of it; the
/// other models of the budget are solved with @p executor. A glass that falls over on the way is an
/// answer: its last row has no terminal spin but a fall. Throws ring::NoBalance where all harmonics
/// have no terminal spin otherwise, or the spin under a load that depends on the phase does not settle; what
/// contact solutions and balances throw.
SpinStudy study_spin(const Study &study, const std::shared_ptr<ElasticFoot> &foot,
                     const ring::LoadAtSpin &load, const Executor &executor,
                     Progress &progress = silent_progress(), Depth depth = Depth::full);

} // namespace stemware::pipeline
