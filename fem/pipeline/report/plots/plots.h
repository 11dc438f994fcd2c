#pragma once

#include "fem/contact/azimuthal_density.h"
#include "fem/pipeline/analysis/budget.h"
#include "fem/pipeline/analysis/comparison.h"
#include "fem/pipeline/analysis/spin_study.h"
#include "fem/pipeline/analysis/sweep/sweep_findings.h"
#include "fem/pipeline/analysis/truncation.h"
#include "fem/pipeline/report/plot.h"
#include "fem/pipeline/report/render/table.h"
#include "fem/pipeline/study/data_files.h"
#include "ring_model/load/ring_stack.h"
#include "ring_model/motion.h"

#include <string>
#include <vector>

/// The plots of the reports. Some are drawn from the results' own files: torque.csv, truncation.csv ...
namespace stemware::pipeline
{

/// Title in keys of a load truncated after @p n of @p n_all harmonics.
std::string truncation_title(unsigned int n, unsigned int n_all);

/// From the paper's terminal spin to the study's: a bar for each named difference, faster and slower in
/// different colours, its size beside it; the rows of the harmonics make one bar. Error bands as whiskers.
/// Numbers below @p rounding [rad/s] are 0.
Plot waterfall_plot(const Budget &budget, double rounding);

/// Sizes of all differences on a logarithmic scale: the steps of the chain, and below them what leaving out
/// one thing changes, beside the error band of the last row. What is smaller than @p rounding [rad/s] is 0,
/// and not drawn. The budget must have a row.
Plot effects_plot(const Budget &budget, double rounding);

/// tau_z(omega) of all harmonics and of the first alone, and below it what the harmonics beyond the first
/// add.
Plot harmonic_torque_plot(const Budget &budget);

/// @p plot with a remark in it and at the end of its caption: the load is the one of rest at every spin.
Plot one_way(Plot plot);

/// A state of the ring whose friction is to be shown.
struct SlidingState
{
  std::string title;
  ring::RingStack load;
  double omega = 0; ///< [rad/s]
};

/// How the rim slips in each state and the friction on it, seen from above; @p radius of the rim [m].
Plot slip_plot(const ring::Motion &motion, double radius, const std::vector<SlidingState> &states);

/// lambda(theta) drawn outwards from the rim as seen from above, its truncations after 1, 2 and 3 harmonics,
/// and the arc of the rim that carries load. Where @p pointwise (sorted by azimuth) is given, it is drawn
/// instead of all harmonics, and tells which arc carries load; else that is where the series is positive. An
/// arrow points to the orbit's centre, whose side @p sense tells.
Plot load_plot(const ring::RingStack &load, const std::vector<fem::AzimuthLoad> &pointwise,
               ring::OrbitSense sense);

/// The load of load_plot() over the azimuth, in N/m, beside its first harmonic and its mean. The place of the
/// orbit's centre is marked.
Plot line_load_plot(const ring::RingStack &load, ring::OrbitSense sense);

/// The load of load_plot() less its mean and first harmonic, over a_0; @p is_pointwise: whether the load is
/// drawn as it was solved.
Plot higher_harmonics_plot(const ring::RingStack &load, bool is_pointwise);

/// sqrt(a_n^2 + b_n^2) / a_0 on a logarithmic scale; @p band half-widths of their errors by n, 0 where they
/// are not known, or empty. Harmonics smaller than their band, or than the last known one, are hollow.
Plot spectrum_plot(const ring::RingStack &load, const std::vector<double> &band = {});

/// tau_z(omega) of all harmonics and of truncations, with the terminal spins of @p rows, the last of which
/// has all harmonics; from torque.csv, torque_table() of @p curve.
Plot torque_plot(const TorqueCurve &curve, const std::vector<SpinRow> &rows);

/// omega(t) of one model of a glass [rad/s].
struct SpinCurve
{
  std::string title;
  std::vector<double> omega;
  unsigned int line_type; ///< of figures/style.gnuplot
};

/// omega(t) of several models of one glass, over the time [s], in rad/s and in turns per second, the last one
/// the paper's; the terminal spin and the time constant of @p all harmonics are marked where they exist, and
/// so are the points that were @p measured.
Plot spin_up_plot(const std::vector<double> &time, const std::vector<SpinCurve> &curves, const SpinRow &all,
                  const std::vector<MeasuredSpin> &measured = {},
                  const std::string &caption = "Spin-up of the glass from rest.");

/// tau_z by the place of the mark of the glass, or of the table where the rim is flat, at rest and at the
/// mean spin in the long run; from phases.csv.
Plot phase_plot(const PhaseStudy &phases);

/// How fast the terminal spin approaches that of all harmonics, where it changes by more than @p rounding of
/// itself; from truncation.csv, which holds @p truncations.
Plot truncation_plot(const Table &truncations, double rounding = 1e-12);

/// truncation_plot() beside the a-priori bound on the torque as a bound on the spin, to first order.
Plot truncation_plot(const TruncationStudy &study, const Table &truncations);

/// How far omega(t) of each truncation is from that of all harmonics, the last of @p rows; from spin_up.csv.
Plot deviation_plot(const std::vector<SpinRow> &rows);

/// A load of `compare` by the name that it is shown with, which says what is one-way.
std::string name_of_load(const std::string &load);

/// Terminal spins as points, a line of its own for each load, the first on top.
Plot comparison_plot(const Comparison &comparison);

/// Change of the terminal spins by the harmonics beyond the first [rad/s], ordered as in comparison_plot().
Plot harmonic_effect_plot(const Comparison &comparison);

/// An entry without its section, and with its unit.
std::string name_of(const SweptEntry &entry);
std::string label_of(const SweptEntry &entry);

/// The plots of a grid: curves over one entry of numbers, one family of curves for each word or each of a
/// few values of the other, or maps over both. Nothing where both entries are words.
std::vector<Plot> grid_plots(const SweepPlan &plan, const FinishedCases &cases);

/// The plots of random samples: how the terminal spin and the harmonic effect are distributed, and which
/// entries they depend on.
std::vector<Plot> sample_plots(const SweepPlan &plan, const FinishedCases &cases,
                               const SweepFindings &findings);

} // namespace stemware::pipeline
