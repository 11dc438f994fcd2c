#include "fem/pipeline/output/answer.h"
#include "fem/pipeline/output/plots/plots.h"
#include "fem/pipeline/output/quantities.h"
#include "fem/pipeline/output/render/gnuplot.h"
#include "fem/pipeline/output/render/plot_script.h"
#include "fem/pipeline/support/numbers.h"
#include "fem/pipeline/support/text.h"

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <functional>

namespace stemware::pipeline
{

namespace
{

std::vector<double> in_milli(const std::vector<double> &values)
{
  std::vector<double> scaled;
  for (const double value : values)
    scaled.push_back(1e3 * value);
  return scaled;
}

/// Relative changes of the terminal spin by the number of harmonics; those below @p rounding say nothing.
Curve change_curve(const std::string &title, const std::vector<SpinRow> &rows, double rounding)
{
  Curve curve = { title, {}, {}, CurveStyle::line_and_points };
  for (const SpinRow &row : rows)
    if (row.relative_change && std::abs(*row.relative_change) > rounding)
      curve.add(row.harmonics, std::abs(*row.relative_change));
  return curve;
}

/// What the a-priori bound on the torque says about the spin, to first order: bound / |d tau / d omega|,
/// relative to the spin.
Curve bound_curve(const TruncationStudy &study, double rounding)
{
  Curve curve = { "a-priori bound, to first order" };
  const double scale = std::abs(study.torque_slope * study.all().omega_terminal().value());
  for (const SpinRow &row : study.rows)
    if (row.bound && *row.bound / scale > rounding)
      curve.add(row.harmonics, *row.bound / scale);
  return curve;
}

} // namespace

namespace
{

/// A thin dotted line across the plot.
std::string marker_line(const std::string &from, const std::string &to)
{
  return "set arrow from " + from + " to " + to + " nohead back lw 1 dt 3 lc rgb \"#555555\"\n";
}

std::string marker_label(const std::string &text, const std::string &place)
{
  return "set label " + gnuplot_text(text) + " at " + place + " font \",12\" textcolor rgb \"#555555\"\n";
}

/// v/R [rad/s]; 0 where the curve does not tell.
double spin_unit_of(const TorqueCurve &curve)
{
  for (std::size_t i = 0; i < curve.omega.size(); ++i)
    if (std::abs(curve.slip_ratio.at(i)) > 1e-6)
      return curve.omega[i] / curve.slip_ratio[i];
  return 0;
}

/// Tics at multiples of 1, 2 or 5 times a power of ten, at most six; gnuplot's own of a linked axis have many
/// digits.
std::string turn_tics(double low, double high)
{
  const double range = high - low;
  if (!(range > 0))
    return "0";
  double step = std::pow(10, std::floor(std::log10(range / 5)));
  step *= range / step > 25 ? 10 : range / step > 10 ? 5 : range / step > 5 ? 2 : 1;
  std::string tics;
  for (double i = std::ceil(low / step - 1e-9); i * step <= high + 1e-9 * range; ++i)
    tics += (tics.empty() ? "" : ", ") + to_short_text(i * step + 0.); // no -0
  return tics;
}

} // namespace

Plot torque_plot(const TorqueCurve &curve, const std::vector<SpinRow> &rows)
{
  CurvePlot plot = {
    "torque",
    "Friction's torque against the spin, n harmonics kept; points: the terminal spins, where "
    "friction's, the lean and the fingers' torque add up to zero.",
    { heading_with_unit(quantity::omega), false, std::pair(curve.omega.front(), curve.omega.back()) },
    { quantity::axis::torque },
    {},
    "set xzeroaxis lt 8\n"
  };
  if (const double unit = spin_unit_of(curve); unit > 0)
  {
    plot.caption +=
      fmt::format(FMT_STRING(" Beyond ω = ±v/R = ±{:.3g} rad/s part of the rim slides backwards."), unit);
    for (const auto &[name, at] : { std::pair("−v/R", -unit), std::pair("+v/R", unit) })
      if (at >= curve.omega.front() && at <= curve.omega.back())
        plot.commands += marker_line(to_text(at) + ", graph 0", to_text(at) + ", graph 1") +
                         marker_label(name, to_text(at) + ", graph 0.96 offset 0.5,0 left");
  }
  std::vector<double> torques;
  for (const ring::Wrench &friction : curve.friction)
    torques.push_back(1e3 * friction.torque);
  const unsigned int n_all = rows.back().harmonics;
  plot.curves.push_back({ truncation_title(n_all, n_all), curve.omega, torques, CurveStyle::line, {}, 1 });
  for (std::size_t i = 0; i < curve.harmonics.size() && curve.harmonics[i] <= 3; ++i)
    plot.curves.push_back({ truncation_title(curve.harmonics[i], n_all),
                            curve.omega,
                            in_milli(curve.truncations[i]),
                            CurveStyle::line,
                            {},
                            static_cast<unsigned int>(i) + 2 });
  for (const SpinRow &row : rows)
    if (const bool all = &row == &rows.back(); row.omega_terminal() && (all || row.harmonics <= 3))
      plot.curves.push_back(
        { "", { *row.omega_terminal() }, { 0 }, CurveStyle::points, {}, all ? 1 : row.harmonics + 1 });
  return curve_plot(plot);
}

Plot spin_up_plot(const std::vector<Curve> &curves, const SpinRow &all, const std::string &caption)
{
  CurvePlot plot = {
    "spin_up",
    caption,
    { heading_with_unit(quantity::time) },
    { heading_with_unit(quantity::omega) },
    curves,
    "set xzeroaxis lt 8\nset link y2 via y / (2 * pi) inverse y * 2 * pi\nset y2tics nomirror; "
    "set y2label \"turns per second\"; set border 11\n"
  };
  if (const auto omega = all.omega_terminal())
  {
    const double end = curves.front().x.back();
    plot.curves.push_back({ "terminal spin", { 0, end }, { *omega, *omega }, CurveStyle::line, {}, 8 });
    plot.commands += marker_label(
      (*omega < 0 ? "−" : "") + format::significant<5>(std::abs(*omega)) + " rad/s",
      "graph 0.98, first " + to_text(*omega) + " offset 0," + (*omega < 0 ? "0.7" : "-0.7") + " right");
    if (const auto time = all.time_constant(); time && *time > 0 && *time < end)
    {
      plot.caption += " Dotted: the time constant with which the terminal spin is approached.";
      plot.commands +=
        marker_line(to_text(*time) + ", graph 0", to_text(*time) + ", graph 1") +
        marker_label(format::significant<3>(*time) + " s",
                     to_text(*time) + ", graph " + (*omega < 0 ? "0.95" : "0.06") + " offset 0.5,0 left");
    }
  }
  Extent spins;
  for (const Curve &curve : plot.curves)
    for (const double spin : curve.y)
      if (std::isfinite(spin))
        spins.include(spin);
  plot.commands += "set y2tics (" +
                   turn_tics(spins.least / boost::math::double_constants::two_pi,
                             spins.most / boost::math::double_constants::two_pi) +
                   ")\n";
  return curve_plot(plot);
}

Plot phase_plot(const PhaseStudy &phases)
{
  const bool glass = phases.n_glass_phases > 1;
  const auto curve = [&](const std::string &title, const std::vector<double> &torques)
  {
    Curve points = { title, {}, in_milli(torques), CurveStyle::points };
    for (const ring::Orientation &phase : phases.phases)
      points.x.push_back((glass ? phase.glass : phase.table) / boost::math::double_constants::degree);
    return points;
  };
  return curve_plot(
    { "phases",
      std::string("Torque of friction by the place of the mark of the ") + (glass ? "glass" : "table") +
        ", at rest and at the mean spin in the long run; over a whole turn this repeats.",
      { quantity::axis::azimuth },
      { quantity::axis::torque },
      { curve("at rest", phases.torque_at_rest), curve("at the mean spin", phases.torque_at_terminal) },
      "set xzeroaxis lt 8; set key width 0\n" });
}

Plot truncation_plot(const std::vector<SpinRow> &rows)
{
  const Curve change = change_curve("terminal spin, relative change", rows, 1e-12);
  CurvePlot plot = { "truncation",
                     "What leaving out the harmonics beyond some number does to the terminal spin.",
                     { "harmonics kept" },
                     { "|Δω / ω|", true },
                     { change } };
  if (!change.x.empty() && change.x.back() <= 8)
    plot.commands = "set xtics 1\nset autoscale xfix; set offsets graph 0.05, graph 0.05\n";
  return curve_plot(plot);
}

Plot truncation_plot(const TruncationStudy &study)
{
  constexpr double rounding = 1e-13;
  return curve_plot({ "terminal_spin",
                      "What is missing in the terminal spin when the load is truncated, relative to all "
                      "harmonics.",
                      { "harmonics kept" },
                      { "|Δω / ω|", true },
                      { change_curve("terminal spin, relative change", study.rows, rounding),
                        bound_curve(study, rounding) } });
}

Plot deviation_plot(const std::vector<double> &time, const std::vector<SpinRow> &rows)
{
  CurvePlot plot = { "deviation",
                     "How far ω(t) of fewer harmonics is from that of all.",
                     { quantity::axis::time },
                     { quantity::axis::deviation, true },
                     {} };
  const SpinRow &all = rows.back();
  const double rounding = 1e-10 * std::abs(all.omega_terminal().value());
  for (const SpinRow &row : rows)
  {
    Curve curve = { truncation_title(row.harmonics, all.harmonics) };
    curve.line_type = static_cast<unsigned int>(plot.curves.size()) + 2; // all harmonics have the first
    for (std::size_t i = 1; i < row.spin_up.size(); ++i)
      if (const double deviation = std::abs(row.spin_up[i] - all.spin_up[i]); deviation > rounding)
        curve.add(time[i], deviation);
    if (!curve.x.empty() && plot.curves.size() < 6)
      plot.curves.push_back(curve);
  }
  return curve_plot(plot);
}

namespace
{

/// A plot with a line for each load, the first on top, and a colour for each moment balance.
CurvePlot plot_by_load(const Comparison &comparison, const std::string &name, const std::string &caption,
                       const std::string &label,
                       const std::function<std::optional<double>(const SpinRow &)> &value)
{
  std::vector<std::string> loads;
  std::size_t longest = 0;
  for (const SpinRow &row : comparison.rows)
    if (std::find(loads.begin(), loads.end(), row.load) == loads.end())
    {
      loads.push_back(row.load);
      longest = std::max(longest, width_of(name_of_load(row.load)));
    }
  CurvePlot plot = {
    name, caption, { label }, { "", false, std::pair(0.5, static_cast<double>(loads.size()) + 0.5) }, {}
  };
  // The SVG terminal of gnuplot takes texts for wider than they are: too much room would be left for the
  // names.
  constexpr double points_per_character = 7.6, width_of_plot = 540;
  const double left = (points_per_character * static_cast<double>(longest) + 15) / width_of_plot;
  plot.commands = "set lmargin at screen " + to_short_text(left) +
                  "; set rmargin at screen 0.95\nset key width 0\nset ytics (";
  for (std::size_t i = 0; i < loads.size(); ++i)
    plot.commands += (i ? ", '" : "'") + name_of_load(loads[i]) + "' " + std::to_string(loads.size() - i);
  plot.commands += ")\nset grid x y\n";
  Extent extent;
  for (const ring::Closure closure : { ring::Closure::paper, ring::Closure::hand, ring::Closure::full })
  {
    Curve curve = { ring::to_string(closure), {}, {}, CurveStyle::points };
    for (std::size_t i = 0; i < loads.size(); ++i)
      if (const SpinRow *row = comparison.find(closure, loads[i]))
        if (const std::optional<double> x = value(*row))
        {
          curve.add(*x, static_cast<double>(loads.size() - i));
          extent.include(*x);
        }
    if (!curve.x.empty())
      plot.curves.push_back(curve);
  }
  plot.commands += tic_commands("x", extent.least, extent.most);
  return plot;
}

} // namespace

Plot comparison_plot(const Comparison &comparison)
{
  return curve_plot(plot_by_load(comparison, "terminal_spins",
                                 "Terminal spin by load, all its harmonics kept, and by moment balance "
                                 "(colours).",
                                 heading_with_unit(quantity::omega_terminal),
                                 [](const SpinRow &row) { return row.omega_terminal(); }));
}

Plot harmonic_effect_plot(const Comparison &comparison)
{
  return curve_plot(plot_by_load(
    comparison, "harmonic_effects",
    "What the harmonics of each load beyond the first do to that terminal spin; less than zero is faster "
    "where the glass spins clockwise.",
    heading_with_unit(quantity::harmonic_effect),
    [&](const SpinRow &row) { return comparison.harmonic_effect(row.closure, row.load).absolute; }));
}

} // namespace stemware::pipeline
