#pragma once

#include "fem/contact/azimuthal_density.h"
#include "fem/geometry/mesh_quality.h"
#include "fem/geometry/section_view.h"
#include "fem/pipeline/analysis/spin_study.h"
#include "fem/pipeline/analysis/sweep/case_list.h"
#include "fem/pipeline/analysis/sweep/sweep_case.h"
#include "fem/pipeline/coupling/contact_report.h"
#include "fem/pipeline/document/document.h"
#include "fem/pipeline/study/data_files.h"

#include <string>
#include <vector>

/// Data of the templates in this folder that no table of a report has: each function adds to a document the
/// tables, texts and values that some of them ask for.
namespace stemware::pipeline
{

/// "load", "line_load", "higher_harmonics" and "spectrum". Where @p pointwise (sorted by azimuth) is given,
/// it is drawn instead of all harmonics, and tells which arc carries load; else that is where the series is
/// positive. @p band: half-widths of the errors of sqrt(a_n^2 + b_n^2) / a_0 by n, 0 where they are not
/// known, or empty.
void add_load_plots(const ring::RingStack &load, const std::vector<fem::AzimuthLoad> &pointwise,
                    const std::vector<double> &band, ring::OrbitSense sense, Document &document);

/// A state of the ring whose friction is to be shown.
struct SlidingState
{
  std::string title;
  ring::RingStack load;
  double omega = 0; ///< [rad/s]
};

/// "slip": how the rim of this @p radius [m] slips in each state, and the friction on it.
void add_slip_plot(const ring::Motion &motion, double radius, const std::vector<SlidingState> &states,
                   Document &document);

/// "torque": the terminal spins of @p rows, the last of which has all harmonics, and those up to 3.
void add_torque_plot(const TorqueCurve &curve, const std::vector<SpinRow> &rows, Document &document);

/// omega(t) of one model of a glass [rad/s].
struct SpinCurve
{
  std::string title;
  std::vector<double> omega;
  unsigned int line_type; ///< of figures/style.gnuplot
};

/// "spin_up": several models of one glass over the time [s], the last one the paper's; the terminal spin and
/// the time constant of @p all harmonics, the points that were @p measured. The caption begins with @p
/// opening.
void add_spin_up_plot(const std::vector<double> &time, const std::vector<SpinCurve> &curves,
                      const SpinRow &all, const std::vector<MeasuredSpin> &measured,
                      const std::string &opening, Document &document);

/// "footprint", "footprint_at_end", "section_stress", "foot_from_above", "section" and "rim", as far as the
/// report has something for them.
void add_foot_plots(const Study &study, const FootReport &foot, Document &document);

/// Adds the fact "pictures", each with "name", "source" and "words", and their data, for a grid: curves over
/// an entry of numbers, one for each value of the other entry, or maps over two entries of four values or
/// more. No pictures for a list from a file and for words alone.
void add_sweep_plots(const CaseList &list, const FinishedCases &finished, Document &document);

} // namespace stemware::pipeline
