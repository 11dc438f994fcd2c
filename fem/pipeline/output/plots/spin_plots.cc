#include "fem/pipeline/output/answer.h"
#include "fem/pipeline/output/plots/plots.h"
#include "fem/pipeline/output/quantities.h"

#include <algorithm>
#include <cmath>

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

Plot torque_plot(const TorqueCurve &curve, const std::vector<SpinRow> &rows)
{
  CurvePlot plot = { "torque",
                     "Torque of friction against the spin, n harmonics kept; the glass spins up to where it "
                     "vanishes (points).",
                     { heading_with_unit(quantity::omega), false,
                       std::pair(curve.omega.front(), curve.omega.back()) },
                     { quantity::axis::torque },
                     {},
                     "set xzeroaxis lt 8\n" };
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

Plot spin_up_plot(const std::vector<Curve> &curves, const std::string &caption)
{
  return curve_plot({ "spin_up",
                      caption,
                      { heading_with_unit(quantity::time) },
                      { heading_with_unit(quantity::omega) },
                      curves,
                      "set xzeroaxis lt 8\n" });
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
    plot.commands = "set xtics 1\n";
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

Plot comparison_plot(const Comparison &comparison)
{
  std::vector<std::string> loads;
  for (const SpinRow &row : comparison.rows)
    if (std::find(loads.begin(), loads.end(), row.load) == loads.end())
      loads.push_back(row.load);
  CurvePlot plot = { "terminal_spins",
                     "Terminal spin by load, all its harmonics kept, and by moment balance (colours).",
                     { heading_with_unit(quantity::omega_terminal) },
                     { "", false, std::pair(0.5, static_cast<double>(loads.size()) + 0.5) },
                     {} };
  // The SVG terminal of gnuplot takes texts for wider than they are: too much room would be left for the
  // names.
  plot.commands = "set lmargin at screen 0.3\nset key width 0\nset ytics (";
  for (std::size_t i = 0; i < loads.size(); ++i)
    plot.commands += (i ? ", '" : "'") + name_of_load(loads[i]) + "' " + std::to_string(loads.size() - i);
  plot.commands += ")\nset grid x y\n";
  for (const ring::Closure closure : { ring::Closure::paper, ring::Closure::hand, ring::Closure::full })
  {
    Curve curve = { ring::to_string(closure), {}, {}, CurveStyle::points };
    for (std::size_t i = 0; i < loads.size(); ++i)
      if (const SpinRow *row = comparison.find(closure, loads[i]); row && row->omega_terminal())
        curve.add(*row->omega_terminal(), static_cast<double>(loads.size() - i));
    if (!curve.x.empty())
      plot.curves.push_back(curve);
  }
  return curve_plot(plot);
}

} // namespace stemware::pipeline
