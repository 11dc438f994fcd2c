#include "fem/pipeline/report/plots/plots.h"
#include "fem/pipeline/report/quantities.h"
#include "fem/pipeline/report/render/table_renderers.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace stemware::pipeline
{

namespace
{

/// v/R [rad/s]; 0 where the curve does not tell.
double spin_unit_of(const TorqueCurve &curve)
{
  for (std::size_t i = 0; i < curve.omega.size(); ++i)
    if (std::abs(curve.slip_ratio.at(i)) > 1e-6)
      return curve.omega[i] / curve.slip_ratio[i];
  return 0;
}

/// The position, from 1 on, of the column with that key in truncation.csv.
double place_in(const Table &table, const std::string &key)
{
  const auto found = std::find_if(table.columns.begin(), table.columns.end(),
                                  [&](const Column &column) { return column.quantity.key == key; });
  return static_cast<double>(found - table.columns.begin() + 1);
}

} // namespace

std::string name_of_load(const std::string &load)
{
  return load == compared_load::foot_at_rest ? load + " (one-way)" : load;
}

std::string truncation_title(unsigned int n, unsigned int n_all)
{
  if (n == 1)
    return "first harmonic";
  return (n == n_all ? "all, n ≤ " : "n ≤ ") + std::to_string(n);
}

Plot torque_plot(const TorqueCurve &curve, const std::vector<SpinRow> &rows)
{
  std::vector<double> harmonics, terminal, line_types;
  std::copy_if(curve.harmonics.begin(), curve.harmonics.end(), std::back_inserter(harmonics),
               [](unsigned int n) { return n <= 3; });
  for (const SpinRow &row : rows)
    if (const bool all = &row == &rows.back(); row.omega_terminal() && (all || row.harmonics <= 3))
    {
      terminal.push_back(*row.omega_terminal());
      line_types.push_back(all ? 1 : row.harmonics + 1);
    }
  const double spin_unit = spin_unit_of(curve);
  Plot plot = plot_from("torque", { { "n_all", double(rows.back().harmonics) },
                                    { "harmonics", harmonics },
                                    { "terminal", terminal },
                                    { "terminal_type", line_types },
                                    { "spin_unit", spin_unit } });
  if (spin_unit > 0)
    plot.caption += fmt::format(
      FMT_STRING(" Beyond ω = ±v/R = ±{:.3g} rad/s part of the rim slides backwards."), spin_unit);
  return plot;
}

Plot spin_up_plot(const std::vector<double> &time, const std::vector<SpinCurve> &curves, const SpinRow &all,
                  const std::vector<MeasuredSpin> &measured, const std::string &caption)
{
  Table table = { "Spin-up from rest", { numbers("time", "s", time) } };
  std::vector<std::string> titles;
  std::vector<double> line_types;
  for (const SpinCurve &curve : curves)
  {
    table.columns.push_back(numbers("omega, " + curve.title, "rad/s", curve.omega));
    titles.push_back(curve.title);
    line_types.push_back(curve.line_type);
  }
  const double time_constant = all.time_constant().value_or(0);
  std::vector<double> measured_time, measured_omega;
  for (const MeasuredSpin &point : measured)
  {
    measured_time.push_back(point.time);
    measured_omega.push_back(point.omega);
  }
  Plot plot = plot_from("spin_up",
                        { { "curve", titles },
                          { "line_type", line_types },
                          { "terminal", all.omega_terminal().value_or(std::nan("")) },
                          { "measured_time", measured_time },
                          { "measured_omega", measured_omega },
                          { "time_constant", time_constant } },
                        data_table(table));
  plot.caption = caption + (measured.empty() ? "" : " Points: measured, Motion/Measured spin file.");
  if (all.omega_terminal() && time_constant > 0 && time_constant < time.back())
    plot.caption += " Dotted: the time constant with which the terminal spin is approached.";
  return plot;
}

Plot phase_plot(const PhaseStudy &phases)
{
  const bool of_glass = phases.n_glass_phases > 1;
  Plot plot = plot_from("phases", { { "of_glass", of_glass } });
  plot.caption = std::string("Torque of friction by the place of the mark of the ") +
                 (of_glass ? "glass" : "table") +
                 ", at rest and at the mean spin in the long run; over a whole turn this repeats.";
  return plot;
}

Plot truncation_plot(const Table &truncations, double rounding)
{
  return plot_from("truncation", { { "change_column", place_in(truncations, "relative_change") },
                                   { "bound_column", 0. },
                                   { "bound_scale", 1. },
                                   { "rounding", rounding } });
}

Plot truncation_plot(const TruncationStudy &study, const Table &truncations)
{
  return plot_from("truncation",
                   { { "change_column", place_in(truncations, "relative_change") },
                     { "bound_column", place_in(truncations, "bound") },
                     { "bound_scale", std::abs(study.torque_slope * study.all().omega_terminal().value()) },
                     { "rounding", 1e-13 } })
    .as("terminal_spin",
        "What is missing in the terminal spin when the load is truncated, relative to all harmonics.");
}

Plot deviation_plot(const std::vector<SpinRow> &rows)
{
  std::vector<double> harmonics;
  for (const SpinRow &row : rows)
    if (!row.spin_up.empty())
      harmonics.push_back(row.harmonics);
  const SpinRow &all = rows.back();
  return plot_from("deviation", { { "n_all", double(all.harmonics) },
                                  { "harmonics", harmonics },
                                  { "rounding", 1e-10 * std::abs(all.omega_terminal().value()) } });
}

namespace
{

/// A plot with a line for each load, the first on top, and a colour for each moment balance.
Plot plot_by_load(const Comparison &comparison, const std::string &name, const std::string &caption,
                  const std::string &label,
                  const std::function<std::optional<double>(const SpinRow &)> &value)
{
  std::vector<std::string> loads, names, closures;
  std::vector<double> places;
  for (const SpinRow &row : comparison.rows)
    if (std::find(loads.begin(), loads.end(), row.load) == loads.end())
    {
      loads.push_back(row.load);
      names.push_back(name_of_load(row.load));
    }
  for (std::size_t i = 0; i < loads.size(); ++i)
    places.push_back(static_cast<double>(loads.size() - i));
  Table table = { caption, { numbers("place from below", "1", places) } };
  for (const ring::Closure closure : { ring::Closure::paper, ring::Closure::hand, ring::Closure::full })
  {
    std::vector<double> values;
    for (const std::string &load : loads)
    {
      const SpinRow *row = comparison.find(closure, load);
      values.push_back((row ? value(*row) : std::nullopt).value_or(std::nan("")));
    }
    if (std::all_of(values.begin(), values.end(), [](double x) { return std::isnan(x); }))
      continue;
    closures.push_back(ring::to_string(closure));
    table.columns.push_back(numbers("closure " + closures.back(), "rad/s", values));
  }
  return plot_from("by_load", { { "x_label", label }, { "row", names }, { "curve", closures } },
                   data_table(table))
    .as(name, caption);
}

} // namespace

Plot comparison_plot(const Comparison &comparison)
{
  return plot_by_load(comparison, "terminal_spins",
                      "Terminal spin by load, all its harmonics kept, and by moment balance "
                      "(colours).",
                      heading_with_unit(quantity::omega_terminal),
                      [](const SpinRow &row) { return row.omega_terminal(); });
}

Plot harmonic_effect_plot(const Comparison &comparison)
{
  return plot_by_load(
    comparison, "harmonic_effects",
    "What the harmonics of each load beyond the first do to that terminal spin; less than zero is faster "
    "where the glass spins clockwise.",
    heading_with_unit(quantity::harmonic_effect),
    [&](const SpinRow &row) { return comparison.harmonic_effect(row.closure, row.load).absolute; });
}

} // namespace stemware::pipeline
