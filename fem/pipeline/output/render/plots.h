#pragma once

#include "fem/contact/pressure_map.h"
#include "fem/pipeline/analysis/yaw_study.h"
#include "fem/pipeline/output/render/report.h"
#include "ring_model/ring_stack.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

/// The pictures of reports. Labels, titles and captions are plain text as in Report. Each figure brings its
/// data along; figures of one report need different names.
namespace stemware::pipeline
{

struct Axis
{
  std::string label; ///< with its unit: "ω (rad/s)"
  bool logarithmic = false;
  std::optional<std::pair<double, double>> range = std::nullopt; ///< nothing: what the data need
};

enum class CurveStyle
{
  line,
  points,
  line_and_points
};

struct Curve
{
  std::string title; ///< in the key; empty: not there
  std::vector<double> x, y;
  CurveStyle style = CurveStyle::line;
  std::vector<double> band = {}; ///< half-width of the error of each y; empty: none
  unsigned int line_type = 0;    ///< of figures/style.gnuplot; 0: the next one
};

/// Curves over one axis.
struct CurvePlot
{
  std::string name, caption;
  Axis x, y;
  std::vector<Curve> curves;
  std::string commands = ""; ///< further gnuplot commands before the plot
};

ReportFigure curve_figure(const CurvePlot &plot);

/// Load per radian where it is known without a series.
struct LoadSample
{
  double theta = 0;  ///< [rad]
  double lambda = 0; ///< [N/rad]
};

/// What a load cut off after @p n of @p n_all harmonics is called in keys.
std::string truncation_title(unsigned int n, unsigned int n_all);

/// lambda(theta) drawn outwards from the rim as seen from above, its truncations after 1, 2 and 3 harmonics,
/// and the arc of the rim that carries load according to @p pointwise (sorted by theta; empty: the whole rim
/// where the series is positive).
ReportFigure load_figure(const ring::RingStack &load, const std::vector<LoadSample> &pointwise);

/// What the harmonics beyond the first add to the load, over a_0.
ReportFigure higher_harmonics_figure(const ring::RingStack &load);

/// sqrt(a_n^2 + b_n^2) / a_0 on a logarithmic scale; @p band half-widths of their errors by n, or empty.
ReportFigure spectrum_figure(const ring::RingStack &load, const std::vector<double> &band = {});

/// p(r, theta) as colours along and across the rim; @p contact_radius [m] is where r - R is zero. The
/// footprint must have a point under pressure.
ReportFigure footprint_figure(const fem::Footprint &footprint, double contact_radius);

/// tau_z(omega) of all harmonics and of truncations, with the spins at which it vanishes.
ReportFigure torque_figure(const TorqueCurve &curve, const std::vector<TruncationRow> &truncations,
                           const std::string &name = "torque");

/// A spin-up to be drawn.
struct SpinUp
{
  std::string title;
  std::vector<double> omega;  ///< [rad/s], one per time
  unsigned int line_type = 0; ///< as in Curve
};

/// omega(t) of several models of the same glass.
ReportFigure spin_up_figure(const std::vector<double> &time, const std::vector<SpinUp> &curves,
                            const std::string &name = "spin_up");

/// How fast the terminal spin and the torque approach those of all harmonics.
ReportFigure truncation_figure(const std::vector<TruncationRow> &truncations);

/// Distance of a quantity from its limit, level by level.
struct ConvergenceSeries
{
  std::string title;
  std::vector<double> size;      ///< cells, order, lines ... of each level
  std::vector<double> error;     ///< |value - limit|
  std::vector<double> band = {}; ///< half-width of the error band of each level; empty: none
};

/// Differences to the limit, on a logarithmic scale, over the resolution. Bars reach from them up to the
/// half-width of the error band: a bar that points downwards is a band that was too narrow.
ReportFigure convergence_figure(const std::string &name, const std::string &caption, const Axis &resolution,
                                const std::string &quantity, const std::vector<ConvergenceSeries> &series);

/// A quantity over two parameters.
struct SweepMap
{
  std::string name, caption;
  Axis x, y;
  std::string quantity; ///< with its unit
  std::vector<double> x_values, y_values;
  std::vector<std::vector<double>> values; ///< [y][x]; nan where a case has failed
};

/// Colours and contour lines.
ReportFigure map_figure(const SweepMap &map);

/// What one uncertain parameter does to a quantity.
struct Sensitivity
{
  std::string parameter;
  double low = 0, high = 0; ///< the quantity's change when the parameter goes down, up by its spread
};

/// Bars to both sides, the longest on top.
ReportFigure tornado_figure(const std::string &name, const std::string &caption, const std::string &quantity,
                            std::vector<Sensitivity> sensitivities);

} // namespace stemware::pipeline
