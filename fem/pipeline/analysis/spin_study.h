#pragma once

#include "fem/pipeline/analysis/budget.h"
#include "fem/pipeline/analysis/study_rows.h"
#include "fem/pipeline/study/motion_section.h"
#include "ring_model/spin/curves.h"
#include "ring_model/spin/hand_drive.h"
#include "ring_model/spin/torque_effect.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
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
  unsigned int n_first = 0;         ///< harmonics of `first`; 0 without a balance
  std::vector<ring::Torques> first; ///< torques of the first n_first harmonics
};

/// Spin-up while the hand's speed changes.
struct DrivenSpinUp
{
  std::vector<double> time;         ///< [s]
  std::vector<double> speed;        ///< v(t) [m/s]
  std::vector<double> acceleration; ///< dv/dt [m/s^2]
  std::vector<double> omega;        ///< all harmonics, error control [rad/s]
  /// Change of omega for linear instead of monotone cubic interpolation of the file, on a rigid rim [rad/s].
  double interpolation_change = 0;               ///< maximum over the times
  double interpolation_change_at_end = 0;        ///< at the last time
  double integration_error = 0;                  ///< requested accuracy [rad/s]
  std::optional<ring::Breakaway> breakaway = {}; ///< if the hand starts from rest
};

/// Spin-ups from rest at equally spaced times, each load in its own balance; NaN after tipping.
struct SpinUpCurves
{
  std::vector<double> time;           ///< [s]
  std::vector<double> adaptive;       ///< all harmonics, error control [rad/s]
  std::vector<double> euler;          ///< all harmonics, forward Euler as in the paper [rad/s]
  std::vector<double> first_harmonic; ///< first harmonic only, error control [rad/s]; empty without a balance
  std::vector<double> yaw_angle;      ///< all harmonics, error control [rad]
  std::vector<double> paper;          ///< the paper's model of the same glass [rad/s]
  std::vector<ring::Instant> instants = {}; ///< ring::instants_of(), all harmonics
  std::optional<DrivenSpinUp> driven = {};  ///< with Motion/Orbit speed file
};

/// Additional results for a load that depends on the phase.
struct PhaseStudy
{
  double spin_ripple = 0; ///< half the range of the spin after the transient [rad/s]
  /// TerminalSpin::uncertainty: uncertainty of the mean spin after the transient [rad/s].
  double spin_uncertainty = 0;
  double zero_of_mean_torque = 0;    ///< zero of the torque averaged over the phases [rad/s]
  double torque_ripple = 0;          ///< half the range over the phases, at the mean spin [N m]
  double least_load = 0;             ///< pointwise minimum over all phases, at rest and mean spin [N/rad]
  double least_contact_fraction = 0; ///< minimum at rest over all sampled phases
  unsigned int n_glass_phases = 1;   ///< sampled phases
  unsigned int n_table_phases = 1;
  std::size_t n_spins = 1;        ///< sampled spins; 1 for a load independent of the spin
  double interpolation_error = 0; ///< of the load between samples, torque_difference()

  /// Sampled phases [rad]; torque at each, at rest and at the mean spin [N m].
  std::vector<ring::Orientation> phases;
  std::vector<double> torque_at_rest;
  std::vector<double> torque_at_terminal;
  bool least_load_is_at_rest = true; ///< false: at the mean spin
};

/// Curves of a study: torques over the spin and spin-ups.
struct StudyCurves
{
  TorqueCurve torque;
  SpinUpCurves spin_up;
  std::vector<ring::Torques> paper; ///< torques; empty if the paper's load failed
};

/// Spin results of a study, with the curves of the first and of all harmonics.
struct SpinStudy : StudyCurves
{
  /// rows_by_harmonics() without loads; others: the paper's model, with Depth::full all models of the budget
  /// and one ring.
  StudyRows rows = {};
  /// All harmonics on one ring; std::nullopt if the study has one ring.
  std::optional<ring::Answer> one_ring = {};
  ring::TorqueEffects torque_effects = {}; ///< for truncation_orders()
  /// ring::terminal_spins() of the last row; empty with waviness, or for a solid body balanced at every spin.
  std::vector<ring::TerminalSpin> terminal_spins = {};
  std::optional<PhaseStudy> phases = {}; ///< std::nullopt without waviness
  /// Interpolation error of the curves' load over a_0; std::nullopt if the load is exact.
  std::optional<double> curve_error = {};

  /// Returns the answer with all harmonics.
  const ring::Answer &answer() const { return rows.answer(); }
};

/// Returns the spin-up with Motion/Orbit speed file, if given, at @p times. Each torque solves the balance of
/// contact, friction and moments at the present speed, acceleration and spin; moment balances hand and full
/// include the hand's tangential force m dv/dt. @p foot: study_foot() with its rings; nullptr for a
/// first-harmonic load on a ring of @p contact_radius [m]. Throws BadInput if the glass tips, and as contact
/// solves, balances and @p observer.
std::optional<DrivenSpinUp> driven_spin_up(const MotionSection &motion, double contact_radius,
                                           const std::shared_ptr<ElasticFoot> &foot,
                                           const std::vector<double> &times,
                                           const ring::TimeObserver &observer = {});

/// Returns the half-width of the band of the last spin of SpinUpCurves::driven: integration error plus the
/// relative @p band of the terminal spin [rad/s]; std::nullopt without @p band or a spin.
std::optional<double> driven_band(const SpinStudy &spin, const std::optional<double> &band);

/// Returns spins for curves [rad/s], ascending from slightly before rest to 1.5 times the fastest terminal
/// spin of @p rows, or to tipping, and the load of the last row, ring::interpolated_for_curves() between
/// them.
std::pair<std::vector<double>, ring::Load> curve_load(const std::vector<LoadedRow> &rows);

/// Returns the curves of the first and the last of @p rows, rows_by_harmonics(), and of the @p paper's model,
/// at the spins of @p of_all, curve_load(), and at the ascending @p times from 0 on [s]. @p euler_step:
/// longest Euler step [s], 0: none; @p observer: of the spin-up of all harmonics. Throws if the balance of
/// all harmonics is lost.
StudyCurves find_curves(const std::vector<LoadedRow> &rows, const LoadedRow &paper,
                        const std::pair<std::vector<double>, ring::Load> &of_all,
                        const std::vector<double> &times, const Executor &executor, double euler_step = 0,
                        const ring::TimeObserver &observer = {});

/// Solves a study: the answer, its curves and the effect of the harmonics; with Depth::full also the models
/// of find_budget().
/// @p load: find_load() of the analysed study. If the glass tips during the spin-up, the last row has a
/// `fall`. Throws ring::NoBalance if there is no terminal spin otherwise, or if the spin does not settle
/// (waviness); and as contact solves and balances.
SpinStudy study_spin(const Analysis &analysis, const BalancedLoad &load, Depth depth = Depth::full);

} // namespace stemware::pipeline
