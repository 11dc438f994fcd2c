#pragma once

#include "fem/pipeline/coupling/ring_load.h"
#include "fem/pipeline/study/study.h"
#include "ring_model/ring_stack.h"
#include "ring_model/coulomb_ring.h"
#include "ring_model/terminal_spin.h"

#include <optional>
#include <vector>

namespace stemware::pipeline
{

/// What is left of the answer when the load is cut off after some harmonics.
struct TruncationRow
{
  unsigned int harmonics = 0;
  double tau_at_rest = 0;    ///< tau_z(omega = 0) [N m]
  double omega_terminal = 0; ///< [rad/s]
  std::optional<double>
    relative_change;       ///< of omega_terminal to that of all harmonics; nothing where that is 0
  double bound = 0;        ///< a-priori bound on the change of tau_z at the full load's terminal spin [N m]
  double load_minimum = 0; ///< smallest value of the truncated load of rest [N/rad]
};

/// Spin of the ring under a load with all its harmonics, and with fewer.
struct YawStudy
{
  ring::Wrench at_rest = {};
  ring::Wrench at_terminal = {};
  ring::TerminalSpin terminal = {};
  std::optional<double>
    time_constant; ///< I_z / |d tau_z / d omega| at the terminal spin [s]; nothing where the slope is 0
  std::vector<TruncationRow> truncations; ///< harmonics 1, 2, 3, 4, 6, 8, 12, 16, 24, 32, ... and all

  /// Without a moment the glass does not spin up: its terminal spin is rounding.
  bool spins_up() const { return truncations.front().relative_change.has_value(); }
};

/// The spin at which the rim is as fast as the glass, v / R [rad/s].
double spin_scale(const ring::RingStack &load, const ring::Motion &motion);

/// Numbers of harmonics at which loads are cut off: 1, 2, 3, 4, 6, 8, 12, 16, ... below @p n_all, then @p
/// n_all.
std::vector<unsigned int> truncation_orders(unsigned int n_all);

/// The terminal spin under the first @p n_harmonics of the load. Throws std::runtime_error when there is
/// none.
ring::TerminalSpin truncated_terminal_spin(const LoadAtSpin &load, const ring::Motion &motion,
                                           unsigned int n_harmonics);

/// Solves for the terminal spin of every truncation. Throws std::runtime_error when there is none.
YawStudy study_yaw(const LoadAtSpin &load, const ring::Motion &motion);

/// tau_z(omega) and the friction force on spins from -1.5 v/R to 1.5 v/R.
struct TorqueCurve
{
  std::vector<double> omega;                    ///< [rad/s]
  std::vector<double> slip_ratio;               ///< omega R / v
  std::vector<ring::Wrench> friction;           ///< of all harmonics
  std::vector<unsigned int> harmonics;          ///< of the truncations
  std::vector<std::vector<double>> truncations; ///< tau_z [N m], [truncation][spin]
};

TorqueCurve torque_curve(const LoadAtSpin &load, const ring::Motion &motion);

/// omega(t) from rest at equally spaced times.
struct SpinUpCurves
{
  std::vector<double> time;           ///< [s]
  std::vector<double> adaptive;       ///< all harmonics, error control [rad/s]
  std::vector<double> euler;          ///< all harmonics, forward Euler as in the paper [rad/s]
  std::vector<double> first_harmonic; ///< first harmonic alone, error control [rad/s]
  std::vector<double> yaw_angle;      ///< all harmonics, error control [rad]
};

/// Equal steps of the forward Euler method in each of @p n_intervals equal intervals of the spin-up.
unsigned int euler_steps(const MotionSection &motion, unsigned int n_intervals);

/// @p beside is the load for the curves that are shown beside the first, thousands of values of which need
/// not be exact; empty: @p load.
SpinUpCurves spin_up_curves(const LoadAtSpin &load, const MotionSection &motion,
                            const LoadAtSpin &beside = {});

} // namespace stemware::pipeline
