#pragma once

#include "fem/pipeline/output/render/report.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

/// Plots of any numbers. Labels, titles and captions are plain text as in Report. Each plot brings its data
/// along; plots of one report need different names.
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
  std::vector<double> x = {}, y = {};
  CurveStyle style = CurveStyle::line;
  std::vector<double> band = {}; ///< half-width of the error of each y; empty: none
  unsigned int line_type = 0;    ///< of figures/style.gnuplot; 0: the next one
  bool is_error = false;         ///< y is an error itself: bars reach from it up to the band
  bool is_hollow = false;        ///< circles, of a style with points

  void add(double at, double value)
  {
    x.push_back(at);
    y.push_back(value);
  }
};

/// Curves over one axis.
struct CurvePlot
{
  std::string name, caption;
  Axis x, y;
  std::vector<Curve> curves;
  std::string commands = ""; ///< further gnuplot commands before the plot
};

Plot curve_plot(const CurvePlot &plot);

/// Curves of errors over the resolution, with a tic at each level. A bar that points downwards is a band that
/// was too narrow.
Plot convergence_plot(CurvePlot plot);

/// A quantity over two parameters.
struct ValueMap
{
  std::string name, caption;
  Axis x, y;
  std::string quantity; ///< with its unit
  std::vector<double> x_values, y_values;
  std::vector<std::vector<double>> values; ///< [y][x]; nan where there is none
};

/// Colours and contour lines.
Plot map_plot(const ValueMap &map);

/// What one uncertain parameter does to a quantity.
struct Sensitivity
{
  std::string parameter;
  double low = 0, high = 0; ///< the quantity's change when the parameter goes down, up by its spread
};

/// Bars to both sides, the longest on top.
Plot tornado_plot(const std::string &name, const std::string &caption, const std::string &quantity,
                  std::vector<Sensitivity> sensitivities);

} // namespace stemware::pipeline
