#pragma once

#include "fem/contact/foot.h"
#include "fem/pipeline/analysis/budget.h"
#include "fem/pipeline/analysis/spin_study.h"
#include "fem/pipeline/coupling/load_report.h"
#include "fem/pipeline/result/results.h"

#include <optional>
#include <string>
#include <vector>

/// Numbers of the page's pictures, added to results as tables and captions. Angles [degrees], sections [mm].
namespace stemware::pipeline
{

/// Adds "load_lines": pointwise load over its mean on the azimuth lines; null unless the foot has lifted off,
/// because only then the series of the load overshoots.
void add_load_lines(const LoadReport &load, Results &results);

/// Adds table @p name ("slip_at_rest"): slip and friction round the rim.
void add_slip_columns(const std::string &name, const ring::Motion &motion, double radius,
                      const ring::RingStack &load, double omega, Results &results);

/// Adds "motion": instants of a spin-up, each with load over mean at 48 azimuths, friction and the sense of
/// its torque at 24 azimuths, the hand's force, and the torque on the glass.
void add_motion(const Study &study, const std::vector<ring::Instant> &instants, Results &results);

/// Adds "torque": friction torque with fewer and with all harmonics and, unless empty, @p of_paper.
void add_torque_columns(const TorqueCurve &curve, const std::vector<double> &of_paper, Results &results);

/// Adds "spin_up": spins with all harmonics, with the first @p n_first harmonics (if not 0), and of the
/// paper's model.
void add_spin_up_columns(const SpinUpCurves &curves, unsigned int n_first, Results &results);

/// Adds "phases": torque over the azimuth of the mark of the glass or the table.
void add_phase_columns(const PhaseStudy &phases, Results &results);

/// Returns p(r, theta) of @p footprint cut by cut, on a scale up to @p largest [Pa], with the load's @p peak
/// pressure and its error @p band at rest [Pa], unless the band is below a tenth of the peak.
Json pressure_map(const fem::PressureMap &footprint, double contact_radius, double largest, double peak,
                  const std::optional<double> &band = {});

} // namespace stemware::pipeline
