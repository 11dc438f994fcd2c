#pragma once

#include "fem/pipeline/analysis/budget.h"
#include "fem/pipeline/analysis/study_rows.h"
#include "fem/pipeline/coupling/driven_load.h"
#include "ring_model/spin/curves.h"
#include "ring_model/spin/torque_effect.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace stemware::pipeline
{

/// Torques on the glass and friction force over the spin; NaN without a balance.
struct TorqueCurve
{
  /// Spins from slightly before rest to beyond the terminal spins, or to tipping [rad/s].
  std::vector<double> omega;
  double spin_scale = 1;            ///< v / R [rad/s]
  std::vector<ring::Torques> all;   ///< torques of all harmonics
  unsigned int n_first = 0;         ///< number of harmonics of `first`; 0 without a balance
  std::vector<ring::Torques> first; ///< torques of the first harmonics
};

/// omega(t) from rest while the hand's speed changes.
struct DrivenSpinUp
{
  std::vector<double> time;         ///< [s]
  std::vector<double> speed;        ///< v(t) [m/s]
  std::vector<double> acceleration; ///< dv/dt [m/s^2]
  std::vector<double> omega;        ///< all harmonics, error control [rad/s]
  /// Change of omega if the file's entries are interpolated linearly instead of by the monotone cubic,
  /// estimated with a first harmonic on a rigid rim in balance [rad/s].
  double interpolation_change = 0;               ///< largest absolute change over the times
  double interpolation_change_at_end = 0;        ///< change at the last time
  double integration_error = 0;                  ///< requested accuracy of the integration [rad/s]
  std::optional<ring::Breakaway> breakaway = {}; ///< breakaway of a hand that starts from rest
};

/// omega(t) from rest at equally spaced times, each load in its own balance; NaN after tipping.
struct SpinUpCurves
{
  std::vector<double> time;           ///< [s]
  std::vector<double> adaptive;       ///< all harmonics, error control [rad/s]
  std::vector<double> euler;          ///< all harmonics, forward Euler as in the paper [rad/s]
  std::vector<double> first_harmonic; ///< first harmonic only, error control [rad/s]; empty without a balance
  std::vector<double> yaw_angle;      ///< all harmonics, error control [rad]
  std::vector<double> paper; ///< the paper's model of the same glass: its moment balance, its load [rad/s]
  std::vector<ring::Instant> instants = {}; ///< ring::instants_of() all harmonics
  std::optional<DrivenSpinUp> driven = {};  ///< under Motion/Orbit speed file, if given
};

/// Additional results for a load that depends on the phase.
struct PhaseStudy
{
  double spin_ripple = 0;      ///< half of the largest minus the smallest spin after the transient [rad/s]
  double spin_uncertainty = 0; ///< uncertainty of the mean spin after the transient, Answer::spin_uncertainty
                               ///< [rad/s]
  double zero_of_mean_torque = 0; ///< zero of the torque averaged over the phases [rad/s]
  double torque_ripple = 0; ///< half of largest minus smallest torque over the phases, at the mean spin [N m]
  double least_load = 0;    ///< pointwise, at rest, of all sampled phases [N/rad]
  double least_contact_fraction = 0; ///< minimum at rest over all sampled phases
  unsigned int n_glass_phases = 1;   ///< sampled
  unsigned int n_table_phases = 1;
  std::size_t n_spins = 1;        ///< sampled; 1 for a load that does not depend on the spin
  double interpolation_error = 0; ///< error of the load between samples, torque_difference()

  /// Sampled phases: azimuths of the marks [rad], torque at rest and at the mean spin [N m].
  std::vector<ring::Orientation> phases;
  std::vector<double> torque_at_rest;
  std::vector<double> torque_at_terminal;
  bool least_load_is_at_rest = true; ///< true if least_load occurs at rest
};

/// Curves of a study: torques over the spin and spin-ups.
struct StudyCurves
{
  TorqueCurve torque;
  SpinUpCurves spin_up;
  std::vector<ring::Torques> paper; ///< torques of the paper's model; empty if its load failed
  unsigned int n_first = 0;         ///< harmonics of the first row
};

/// Results about the spin under a load, with the curves of the first and of all harmonics.
struct SpinStudy : StudyCurves
{
  std::vector<ring::Answer> rows = {}; ///< one row per number of harmonics: rows_by_harmonics()
  std::optional<ring::Answer>
    one_ring = {};    ///< all harmonics on one ring; std::nullopt if the study has one ring
  Budget budget = {}; ///< without rows for Depth::answer
  ring::TorqueEffects torque_effects = {}; ///< for truncation_orders()
  /// ring::terminal_spins() of the last row; empty with waviness, or if a torque takes minutes (a solid body
  /// in balance at every spin).
  std::vector<ring::TerminalSpin> terminal_spins = {};
  std::optional<PhaseStudy> phases = {}; ///< std::nullopt without waviness
  /// Interpolation error of the load of the curves over a_0; std::nullopt if the load is exact.
  std::optional<double> curve_error = {};

  /// Returns the answer with all harmonics.
  const ring::Answer &answer() const { return rows.back(); }
  /// Returns true for Depth::answer: answer and curves only.
  bool is_quick() const { return budget.rows.empty(); }
};

/// Returns the half-width of the band of the last spin under the speeds of a file: the error of the
/// integration plus the relative @p band of the terminal spin [rad/s]; std::nullopt without that band or a
/// spin.
std::optional<double> driven_band(const SpinStudy &spin, const std::optional<double> &band);

/// Load of all harmonics for curves.
struct CurveLoad
{
  /// Spins of the torque curve, ascending: from slightly before rest to one and a half times the fastest
  /// terminal spin, or to tipping [rad/s].
  std::vector<double> spins;
  ring::Load load; ///< ring::interpolated_for_curves() between the first and the last spin
};

/// Returns the load of the last of @p rows for curves.
CurveLoad curve_load(const Study &study, const std::vector<LoadedRow> &rows);

/// Returns the curves of the first and the last of @p rows, rows_by_harmonics(), and of the @p paper's model,
/// at the spins of @p of_all and over the time of the study. @p euler_step: longest Euler step [s], 0: none.
/// @p observer: of the spin-up of all harmonics. Throws if the balance of all harmonics is lost.
StudyCurves find_curves(const Study &study, const std::vector<LoadedRow> &rows, const LoadedRow &paper,
                        const CurveLoad &of_all, const Executor &executor, double euler_step = 0,
                        const ring::TimeObserver &observer = {});

/// Returns the spin-up under the speeds of Motion/Orbit speed file, with the contact in balance at every
/// instant, at @p times; std::nullopt without such a file. @p foot is study_foot() with its rings chosen.
/// Throws as the torque and @p observer.
std::optional<DrivenSpinUp> driven_spin_up(const Study &study, const std::shared_ptr<ElasticFoot> &foot,
                                           const std::vector<double> &times,
                                           const ring::TimeObserver &observer = {});

/// Solves everything; with Depth::answer only the answer, its curves and the effect of the harmonics. @p
/// foot: study_foot(); @p load: find_load() of the foot; the other models of the budget are solved with @p
/// executor. A glass that tips on the way is an answer: the last row has no terminal spin but a `fall`.
/// Throws ring::NoBalance if all harmonics have no terminal spin otherwise, or if the spin under a load that
/// depends on the phase does not settle; and as contact solves and balances.
SpinStudy study_spin(const Study &study, const std::shared_ptr<ElasticFoot> &foot, const BalancedLoad &load,
                     const Executor &executor, Progress &progress = silent_progress(),
                     Depth depth = Depth::full);

} // namespace stemware::pipeline
