#pragma once

#include "fem/pipeline/analysis/quantity.h"
#include "fem/pipeline/analysis/spin_study.h"

#include <cstddef>
#include <limits>
#include <vector>

/// Columns of curves for data files, pictures and Python. A row is the index of a point; the curves must
/// outlive the columns.
namespace stemware::pipeline
{

/// Returns the indices of @p n points, or of at most about @p max_points at equal steps, and of the last
/// point.
std::vector<std::size_t> points_of(std::size_t n,
                                   std::size_t max_points = std::numeric_limits<std::size_t>::max());

/// Returns torques of friction, lean and grip, and the friction force, over the spin.
Fields<std::size_t> torque_columns(const TorqueCurve &curve);

/// Returns the spin-up from rest. @p n_first: harmonics of the drawn SpinUpCurves::first_harmonic; 0: not
/// drawn.
Fields<std::size_t> spin_up_columns(const SpinUpCurves &curves, unsigned int n_first = 1);

/// Returns the spin-up at the speeds of Motion/Orbit speed file.
Fields<std::size_t> driven_columns(const DrivenSpinUp &driven);

/// Returns the torque over the phase (azimuths of the marks of glass and table in the slip frame).
Fields<std::size_t> phase_columns(const PhaseStudy &phases);

/// Returns the effects of harmonics on tau_z over the spin.
Fields<std::size_t> torque_change_columns(const ring::TorqueEffects &effects);

} // namespace stemware::pipeline
