#pragma once

#include "fem/contact/pressure_map.h"
#include "fem/geometry/mesh_quality.h"
#include "fem/pipeline/analysis/comparison.h"
#include "fem/pipeline/analysis/spin_study.h"
#include "fem/pipeline/analysis/sweep/sweep_findings.h"
#include "fem/pipeline/analysis/truncation.h"
#include "fem/pipeline/output/render/curve_plot.h"
#include "ring_model/load/ring_stack.h"

#include <string>
#include <vector>

/// The plots of the reports.
namespace stemware::pipeline
{

/// What a load truncated after @p n of @p n_all harmonics is called in keys.
std::string truncation_title(unsigned int n, unsigned int n_all);

/// lambda(theta) drawn outwards from the rim as seen from above, its truncations after 1, 2 and 3 harmonics,
/// and the arc of the rim that carries load. Where @p pointwise (sorted by azimuth) is given, it is drawn
/// instead of all harmonics, and tells which arc carries load; else that is where the series is positive. An
/// arrow points to the orbit's centre, whose side @p sense tells.
Plot load_plot(const ring::RingStack &load, const std::vector<fem::AzimuthLoad> &pointwise,
               ring::OrbitSense sense);

/// What the harmonics beyond the first add to the load, over a_0; @p pointwise as in load_plot().
Plot higher_harmonics_plot(const ring::RingStack &load, const std::vector<fem::AzimuthLoad> &pointwise = {});

/// lambda(theta) / R in N/m over the azimuth, beside its first harmonic and its mean; @p pointwise as in
/// load_plot(). The place of the orbit's centre is marked.
Plot line_load_plot(const ring::RingStack &load, const std::vector<fem::AzimuthLoad> &pointwise,
                    ring::OrbitSense sense);

/// sqrt(a_n^2 + b_n^2) / a_0 on a logarithmic scale; @p band half-widths of their errors by n, 0 where they
/// are not known, or empty. Harmonics smaller than their band, or than the last known one, are hollow.
Plot spectrum_plot(const ring::RingStack &load, const std::vector<double> &band = {});

/// p(r, theta) as colours along and across the rim; @p contact_radius [m] is where r - R is zero. The
/// footprint must have a point under pressure.
Plot footprint_plot(const fem::PressureMap &footprint, double contact_radius);

/// tau_z(omega) of all harmonics and of truncations, with the terminal spins of @p rows, the last of which
/// has all harmonics.
Plot torque_plot(const TorqueCurve &curve, const std::vector<SpinRow> &rows);

/// omega(t) of several models of one glass, over the time [s], in rad/s and in turns per second; the terminal
/// spin and the time constant of @p all harmonics are marked where they exist.
Plot spin_up_plot(const std::vector<Curve> &curves, const SpinRow &all,
                  const std::string &caption = "Spin-up of the glass from rest.");

/// tau_z by the place of the mark of the glass, or of the table where the rim is flat, at rest and at the
/// mean spin in the long run.
Plot phase_plot(const PhaseStudy &phases);

/// How fast the terminal spin approaches that of all harmonics.
Plot truncation_plot(const std::vector<SpinRow> &rows);

/// As above, beside the a-priori bound.
Plot truncation_plot(const TruncationStudy &study);

/// How far omega(t) of each truncation is from that of all harmonics, the last of @p rows.
Plot deviation_plot(const std::vector<double> &time, const std::vector<SpinRow> &rows);

/// Terminal spins as points, a line of its own for each load, the first on top.
Plot comparison_plot(const Comparison &comparison);

/// What the harmonics beyond the first do to those spins [rad/s], in the same order.
Plot harmonic_effect_plot(const Comparison &comparison);

/// The faces of a mesh's contact zone, seen from above.
Plot contact_zone_plot(const std::vector<fem::Quadrilateral> &faces);

/// How many cells of a mesh have which scaled Jacobian.
Plot quality_plot(const std::vector<double> &jacobians);

/// An entry without its section, and as an axis with its unit.
std::string name_of(const SweptEntry &entry);
Axis axis_of(const SweptEntry &entry);

/// The plots of a grid: curves over one entry of numbers, one family of curves for each word or each of a
/// few values of the other, or maps over both. Nothing where both entries are words.
std::vector<Plot> grid_plots(const SweepPlan &plan, const FinishedCases &cases);

/// The plots of random samples: how the terminal spin and the harmonic effect are distributed, and which
/// entries they depend on.
std::vector<Plot> sample_plots(const SweepPlan &plan, const FinishedCases &cases,
                               const SweepFindings &findings);

} // namespace stemware::pipeline
