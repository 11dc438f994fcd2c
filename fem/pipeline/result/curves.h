#pragma once

#include "fem/contact/foot.h"
#include "fem/pipeline/analysis/spin_study.h"
#include "fem/pipeline/coupling/balanced_load.h"
#include "fem/pipeline/result/results.h"

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
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

// ---- numbers of the page's pictures, added to results as tables. Angles [degrees], sections [mm].

/// Adds "load_lines": pointwise load over its mean on the azimuth lines; null unless the foot has lifted off,
/// because only then the series of the load overshoots.
void add_load_lines(const LoadReport &load, Results &results);

/// Adds table @p name ("slip_at_rest"): slip and friction round the rim.
void add_slip(const std::string &name, const ring::Motion &motion, double radius, const ring::RingStack &load,
              double omega, Results &results);

/// Adds "motion": instants of a spin-up, each with load over mean at 48 azimuths, friction and the sense of
/// its torque at 24 azimuths, the hand's force, and the torque on the glass.
void add_motion(const ring::Motion &motion, double radius, const std::vector<ring::Instant> &instants,
                Results &results);

/// Adds the pictures "torque" and "spin_up" with the columns @p torque and @p spin_up, and "driven".
void add_curves(const StudyCurves &curves, const Fields<std::size_t> &torque,
                const Fields<std::size_t> &spin_up, Results &results);

/// Returns p(r, theta) of @p footprint cut by cut, on a scale up to @p largest [Pa], with the load's @p peak
/// pressure and its error @p band at rest [Pa], unless the band is below a tenth of the peak.
Json pressure_map(const fem::PressureMap &footprint, double contact_radius, double largest, double peak,
                  const std::optional<double> &band = {});

} // namespace stemware::pipeline
