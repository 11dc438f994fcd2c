#pragma once

#include "fem/contact/foot.h"
#include "fem/pipeline/analysis/budget.h"
#include "fem/pipeline/analysis/spin_study.h"
#include "fem/pipeline/coupling/load_report.h"
#include "fem/pipeline/result/results.h"

#include <optional>
#include <string>
#include <vector>

/// Numbers of the page's pictures: each function adds tables to results and captions to their words. Angles
/// in degrees, lengths of a section in mm.
namespace stemware::pipeline
{

/// Adds "load_lines": pointwise load over its mean on the azimuth lines if the foot has lifted off, where the
/// series of the load overshoots; else null.
void add_load_lines(const LoadReport &load, Results &results);

/// Adds "slip_at_rest" or another @p name: slip and friction round the rim.
void add_slip_columns(const std::string &name, const ring::Motion &motion, double radius,
                      const ring::RingStack &load, double omega, Results &results);

/// Adds "motion": instants of a spin-up, each with the load over its mean at 48 places of the rim and the
/// friction at 24, the sense of its torque, the hand's force, and the torque that is left.
void add_motion(const Study &study, const std::vector<ring::Instant> &instants, Results &results);

/// Adds "torque": torque of friction with fewer and with all harmonics and, if given, of the paper's model.
void add_torque_columns(const TorqueCurve &curve, const std::vector<double> &of_paper, Results &results);

/// Adds "spin_up": spins with all harmonics, with the first @p n_first unless 0, and of the paper's model.
void add_spin_up_columns(const SpinUpCurves &curves, unsigned int n_first, Results &results);

/// Adds "phases": torque over the azimuth of the mark of the glass or the table.
void add_phase_columns(const PhaseStudy &phases, Results &results);

/// Returns p(r, theta) of @p footprint cut by cut, on a scale that ends at @p largest [Pa], with the load's
/// @p peak pressure and the error band of the peak at rest [Pa]; the band is left out up to a tenth of the
/// peak.
Json pressure_map(const fem::PressureMap &footprint, double contact_radius, double largest, double peak,
                  const std::optional<double> &band = {});

} // namespace stemware::pipeline
