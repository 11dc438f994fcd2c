#include "fem/pipeline/output/render/gnuplot.h"
#include "fem/pipeline/output/render/plot_script.h"
#include "fem/pipeline/output/render/table_renderers.h"
#include "fem/pipeline/support/numbers.h"
#include "fem/pipeline/support/text.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace stemware::pipeline
{

namespace
{

/// Tics at 1, 2 and 5 times powers of ten: a logarithmic axis of less than two decades has too few powers.
std::string fine_tics(double low, double high)
{
  std::ostringstream tics;
  for (int power = static_cast<int>(std::floor(std::log10(low))); std::pow(10, power) <= high; ++power)
    for (const int digit : { 1, 2, 5 })
      if (const double value = digit * std::pow(10, power); value >= low && value <= high)
        tics << (tics.tellp() > 0 ? ", " : "") << '"' << (digit > 1 ? std::to_string(digit) + "·" : "")
             << "10^{" << power << "}\" " << value;
  return tics.str();
}

} // namespace

std::string axis_commands(const std::string &which, const Axis &axis)
{
  std::ostringstream script;
  script << "set " << which << "label " << gnuplot_text(axis.label) << '\n';
  if (axis.logarithmic)
    script << "set logscale " << which << "; set format " << which << " \"10^{%T}\"; set m" << which
           << "tics 1\n";
  if (axis.range)
  {
    const auto [low, high] = *axis.range;
    script << "set " << which << "range [" << low << ':' << high << "]\n";
    if (axis.logarithmic && high < 100 * low)
      script << "set " << which << "tics (" << fine_tics(low, high) << ")\n";
  }
  return script.str();
}

std::string tic_commands(const std::string &which, double low, double high)
{
  const double range = high - low;
  if (!(range > 0) || !std::isfinite(range))
    return "";
  // The least of 1, 2 and 5 times a power of ten that leaves no more than four steps.
  int power = static_cast<int>(std::floor(std::log10(range / 4)));
  const double steps = range / std::pow(10, power);
  const int factor = steps <= 4 ? 1 : steps <= 8 ? 2 : steps <= 20 ? 5 : 10;
  std::string commands = "set " + which + "tics " + to_text(factor * std::pow(10, power)) + "\n";
  power += factor == 10 ? 1 : 0;
  const double largest = std::max(std::abs(low), std::abs(high));
  if (largest >= 1e-3 && largest < 1e6)
    commands += "set format " + which + " \"%." + std::to_string(std::max(0, -power)) + "f\"\n";
  return commands;
}

std::string colour_commands(const std::string &label, double low, double high)
{
  // Places on the page: terminals differ in the room that they think a text needs.
  return "set rmargin at screen 0.77\nset colorbox user origin screen 0.79, graph 0 size screen 0.03, graph "
         "1\n"
         "set label 1 " +
         gnuplot_text(label) + " at screen 0.97, graph 0.5 rotate by 90 center\nset cbrange [" +
         to_text(low) + ":" + to_text(high) + "]\n" + tic_commands("cb", low, high);
}

namespace
{

/// The points of a curve; "ω (rad/s)" names a column ω with the unit rad/s.
Table points_of(const CurvePlot &plot, const Curve &curve)
{
  const auto column = [](const Axis &axis, const std::vector<double> &values)
  {
    const auto unit = axis.label.rfind(" (");
    return unit == std::string::npos || axis.label.back() != ')'
             ? numbers(axis.label, "1", values)
             : numbers(axis.label.substr(0, unit), axis.label.substr(unit + 2, axis.label.size() - unit - 3),
                       values);
  };
  Table table = { curve.title.empty() ? plot.caption : curve.title,
                  { column(plot.x, curve.x), column(plot.y, curve.y) } };
  if (!curve.band.empty())
    table.columns.push_back(
      numbers(curve.is_error ? "half-width of the error band" : "half-width of its error band",
              table.columns.back().quantity.unit, curve.band));
  return table;
}

/// The parts of gnuplot's plot command that draw one curve.
std::string drawing(const Curve &curve, std::size_t index, unsigned int line_type)
{
  std::ostringstream plot;
  const std::string title = curve.title.empty() ? "notitle" : "title " + gnuplot_text(curve.title);
  const std::string type = " lt " + std::to_string(line_type) + " ";
  const std::string block = "data index " + std::to_string(index) + " using ";
  if (!curve.band.empty())
  {
    if (curve.style == CurveStyle::line)
      plot << block << "1:($2 - $3):($2 + $3) with filledcurves fs transparent solid 0.2 noborder" << type
           << "notitle, ";
    else
      plot << block << (curve.is_error ? "1:2:2:3" : "1:2:3") << " with yerrorbars" << type << "dt 1 lw 1 "
           << (curve.is_error ? "ps 0 " : "") << "notitle, ";
  }
  const char *style = curve.style == CurveStyle::line     ? "with lines"
                      : curve.style == CurveStyle::points ? "with points"
                                                          : "with linespoints";
  plot << block << "1:2 " << style << type << (curve.is_hollow ? "pt 6 " : "") << title;
  return plot.str();
}

/// Whether gnuplot can place a point of the curve; where it can place none at all, it fails.
bool has_points(const CurvePlot &plot, const Curve &curve)
{
  const auto can_be_placed = [](const Axis &axis, double value)
  { return std::isfinite(value) && (value > 0 || !axis.logarithmic); };
  for (std::size_t i = 0; i < curve.x.size(); ++i)
    if (can_be_placed(plot.x, curve.x[i]) && can_be_placed(plot.y, curve.y[i]))
      return true;
  return false;
}

/// Tics for a horizontal axis that is narrow beside its values, on which gnuplot's own would overlap.
std::string tics_of_narrow_axis(const CurvePlot &plot)
{
  constexpr double share = 0.02; // labels of more than four digits
  if (plot.x.logarithmic || plot.x.range)
    return "";
  Extent x_axis;
  for (const Curve &curve : plot.curves)
    for (const double x : curve.x)
      x_axis.include(x);
  return x_axis.most - x_axis.least < share ? tic_commands("x", x_axis.least, x_axis.most) : "";
}

/// Room for short titles in the key: with the style's allowance for long ones they would overlap.
std::string key_of_short_titles(const CurvePlot &plot)
{
  constexpr std::size_t short_title = 6;
  const bool all_are_short =
    std::all_of(plot.curves.begin(), plot.curves.end(),
                [](const Curve &curve) { return width_of(curve.title) < short_title; });
  return all_are_short ? "set key width 1\n" : "";
}

/// Instead of a plot without a single point.
constexpr char nothing_to_show[] = R"gp(unset logscale; unset tics; set xrange [0:1]; set yrange [0:1]
set label "nothing to show" at 0.5,0.5 center
plot NaN notitle
)gp";

} // namespace

Plot curve_plot(const CurvePlot &plot)
{
  std::vector<Table> blocks;
  std::string drawings;
  unsigned int line_type = 0;
  bool is_empty = true;
  for (std::size_t i = 0; i < plot.curves.size(); ++i)
  {
    const Curve &curve = plot.curves[i];
    blocks.push_back(points_of(plot, curve));
    is_empty = is_empty && !has_points(plot, curve);
    drawings +=
      (i == 0 ? "" : ", \\\n     ") + drawing(curve, i, curve.line_type > 0 ? curve.line_type : ++line_type);
  }
  const std::string script = axis_commands("x", plot.x) + axis_commands("y", plot.y) +
                             tics_of_narrow_axis(plot) + key_of_short_titles(plot) + plot.commands +
                             (is_empty ? nothing_to_show : "plot " + drawings + "\n");
  return { plot.name, plot.caption, script, data_tables(blocks) };
}

Plot convergence_plot(CurvePlot plot)
{
  std::string sizes;
  for (const Curve &curve : plot.curves)
    for (const double size : curve.x)
      sizes += (sizes.empty() ? "" : ", ") + to_text(size);
  plot.commands =
    "set xtics (" + sizes + ") format \"%g\"\nset autoscale xfix; set offsets graph 0.05, graph 0.05\n";
  return curve_plot(plot);
}

} // namespace stemware::pipeline
