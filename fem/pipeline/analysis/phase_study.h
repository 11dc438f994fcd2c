#pragma once

#include "fem/pipeline/analysis/yaw_study.h"
#include "fem/pipeline/coupling/phase_contact.h"
#include "fem/pipeline/study/study.h"

#include <cstddef>
#include <vector>

namespace stemware::pipeline
{

/// What a load that depends on the phase adds to a study of the spin.
struct PhaseFigures
{
  double spin_ripple = 0;         ///< half of largest minus smallest spin in the long run [rad/s]
  double spin_uncertainty = 0;    ///< of the mean spin in the long run [rad/s]
  double zero_of_mean_torque = 0; ///< spin at which the torque vanishes on average over the phases [rad/s]
  double torque_ripple = 0; ///< half of largest minus smallest torque over the phases, at the mean spin [N m]
  double least_load = 0;    ///< pointwise, at rest, of all sampled phases [N/rad]
  double least_contact_fraction = 0; ///< at rest, of all sampled phases
  unsigned int n_glass_phases = 1;   ///< sampled
  unsigned int n_table_phases = 1;
  std::size_t n_spins = 1;        ///< sampled; 1 for a frozen load
  double interpolation_error = 0; ///< of the load between samples, over a_0

  /// At each sampled phase: where the marks stand [rad], and the torque at rest and at the mean spin [N m].
  std::vector<fem::FootPhase> phases;
  std::vector<double> torque_at_rest;
  std::vector<double> torque_at_terminal;
};

/// study_yaw() for a load that depends on the phase. Terminal spins are means in the long run, with all
/// harmonics and for each truncation; torques, slopes and time constants are those of the mean load over all
/// phases; bounds and least loads the worst of all phases. Throws std::runtime_error where the spin does not
/// settle.
YawStudy study_yaw(const PhasedLoad &load, const PhasePeriods &periods, const ring::Motion &motion,
                   PhaseFigures &figures);

/// spin_up_curves() for a load that depends on the phase.
SpinUpCurves spin_up_curves(const PhasedLoad &load, const MotionSection &motion);

} // namespace stemware::pipeline
