#include "fem/pipeline/report/plots/plots.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace stemware::pipeline
{

namespace
{

using Json = nlohmann::ordered_json;

/// A line for each load, the first on top, a column for each moment balance that has a value.
void add_plot_by_load(const Comparison &comparison, const std::string &name, const std::string &caption,
                      const Quantity &what,
                      const std::function<std::optional<double>(const SpinRow &)> &value, Document &document)
{
  std::vector<std::string> loads, closures;
  for (const SpinRow &row : comparison.rows)
    if (std::find(loads.begin(), loads.end(), row.load) == loads.end())
      loads.push_back(row.load);
  Table table = { what.name, { { { "row" }, {} } } };
  for (const std::string &load : loads)
    table.columns.front().cells.push_back(name_of_load(load));
  for (const ring::Closure closure : { ring::Closure::paper, ring::Closure::hand, ring::Closure::full })
  {
    const auto in_closure = [&](const std::string &load)
    {
      const SpinRow *row = comparison.find(closure, load);
      return row ? value(*row) : std::nullopt;
    };
    if (std::none_of(loads.begin(), loads.end(), in_closure))
      continue;
    closures.push_back(ring::to_string(closure));
    table.columns.push_back(numbers("closure " + closures.back(), what.unit, loads, in_closure));
  }
  document.tables[name] = table;
  document.plots[name] = { { "caption", caption },
                           { "x_label", heading_with_unit(what) },
                           { "curve", closures } };
}

} // namespace

std::string name_of_load(const std::string &load)
{
  return load == compared_load::foot_at_rest ? load + " (one-way)" : load;
}

void add_torque_plot(const TorqueCurve &curve, const std::vector<SpinRow> &rows, Document &document)
{
  Json harmonics = Json::array(), terminal = Json::array(), line_types = Json::array();
  std::copy_if(curve.harmonics.begin(), curve.harmonics.end(), std::back_inserter(harmonics),
               [](unsigned int n) { return n <= 3; });
  for (const SpinRow &row : rows)
    if (const bool all = &row == &rows.back(); row.omega_terminal() && (all || row.harmonics <= 3))
    {
      terminal.push_back(*row.omega_terminal());
      line_types.push_back(all ? 1 : row.harmonics + 1);
    }
  const std::optional<double> spin_unit = curve.spin_unit();
  document.plots["torque"] = { { "n_all", rows.back().harmonics },
                               { "harmonics", harmonics },
                               { "terminal", terminal },
                               { "terminal_type", line_types },
                               { "spin_unit", spin_unit ? Json(*spin_unit) : Json(nullptr) } };
}

void add_spin_up_plot(const std::vector<double> &time, const std::vector<SpinCurve> &curves,
                      const SpinRow &all, const std::vector<MeasuredSpin> &measured,
                      const std::string &opening, Document &document)
{
  Table table = { "Spin-up from rest", { numbers("time", "s", time) } };
  Json titles = Json::array(), line_types = Json::array(), times = Json::array(), spins = Json::array();
  for (const SpinCurve &curve : curves)
  {
    table.columns.push_back(numbers("omega, " + curve.title, "rad/s", curve.omega));
    titles.push_back(curve.title);
    line_types.push_back(curve.line_type);
  }
  for (const MeasuredSpin &point : measured)
  {
    times.push_back(point.time);
    spins.push_back(point.omega);
  }
  const double time_constant = all.time_constant().value_or(0);
  document.tables["spin_up_curves"] = table;
  document.plots["spin_up"] = { { "opening", opening },
                                { "curve", titles },
                                { "line_type", line_types },
                                { "terminal", all.omega_terminal().value_or(std::nan("")) },
                                { "measured_time", times },
                                { "measured_omega", spins },
                                { "has_measured", !measured.empty() },
                                { "time_constant", time_constant },
                                { "has_time_constant", all.omega_terminal() && time_constant > 0 &&
                                                         time_constant < time.back() } };
}

void add_deviation_plot(const std::vector<SpinRow> &rows, Document &document)
{
  Json harmonics = Json::array();
  for (const SpinRow &row : rows)
    if (!row.spin_up.empty())
      harmonics.push_back(row.harmonics);
  document.plots["deviation"] = { { "n_all", rows.back().harmonics },
                                  { "harmonics", harmonics },
                                  { "rounding", 1e-10 * std::abs(rows.back().omega_terminal().value()) } };
}

void add_comparison_plots(const Comparison &comparison, Document &document)
{
  add_plot_by_load(comparison, "terminal_spins",
                   "Terminal spin by load, all its harmonics kept, and by moment balance (colours).",
                   quantity_named("omega_terminal"), &SpinRow::omega_terminal, document);
  add_plot_by_load(
    comparison, "harmonic_effects",
    "What the harmonics of each load beyond the first do to that terminal spin; less than zero is faster "
    "where the glass "
    "spins clockwise.",
    quantity_named("harmonic_effect"),
    [&](const SpinRow &row) { return comparison.harmonic_effect(row.closure, row.load).absolute; }, document);
}

} // namespace stemware::pipeline
