#include "fem/pipeline/analysis/sweep/curve_gaps.h"
#include "fem/pipeline/report/plots/plots.h"
#include "fem/pipeline/report/quantities.h"
#include "fem/pipeline/report/render/table_renderers.h"
#include "fem/pipeline/support/numbers.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace stemware::pipeline
{

namespace
{

using CaseValue = std::function<std::optional<double>(const CaseResult &)>;

/// Something to draw: a quantity of the table, or a harmonic's amplitude.
struct Drawing
{
  std::string name;  ///< of the plot
  std::string label; ///< of the axis, with its unit
  std::string caption;
  CaseValue value;
  bool is_effect = false; ///< a difference between the spins of all harmonics and of the first alone
  bool is_spin = false;
};

CaseValue value_of(const std::string &quantity, double scale = 1)
{
  return [index = quantity_index(quantity), scale](const CaseResult &result) -> std::optional<double>
  {
    const std::optional<double> &value = result.values[index];
    return value ? std::optional(scale * *value) : std::nullopt;
  };
}

CaseValue amplitude_of(unsigned int n)
{
  const std::string tail = std::to_string(n) + "/a_0";
  return [a = quantity_index("a_" + tail), b = quantity_index("b_" + tail)](const CaseResult &result)
  { return std::hypot(result.values[a].value(), result.values[b].value()); };
}

std::vector<Drawing> drawings()
{
  return { { "terminal_spin", heading_with_unit(quantity::omega_terminal),
             "Terminal spin under all harmonics of the load", value_of("terminal spin"), false, true },
           { "absolute_harmonic_effect", "harmonic effect (rad/s)",
             "What the harmonics of the load beyond the first add to the terminal spin",
             value_of("absolute harmonic effect"), true },
           { "harmonic_effect", "harmonic effect (%)",
             "How much faster the harmonics of the load beyond the first make the glass",
             value_of("harmonic effect"), true },
           { "second_harmonic", "√(a_2² + b_2²) / a_0",
             "Amplitude of the load's second harmonic over its mean", amplitude_of(2) },
           { "third_harmonic", "√(a_3² + b_3²) / a_0", "Amplitude of the load's third harmonic over its mean",
             amplitude_of(3) },
           { "contact_fraction", "share of the rim that carries load", "Share of the rim that carries load",
             value_of("contact fraction") },
           { "torque_at_rest", "τ_z at rest (mN m)", "Torque of friction on the glass that does not spin yet",
             value_of("torque at rest", 1e3) } };
}

double nan_where_missing(const std::optional<double> &value)
{
  return value.value_or(std::nan(""));
}

double value_in(const FinishedCases &cases, std::size_t index, const CaseValue &value)
{
  const CaseResult &result = cases.at(index);
  return nan_where_missing(result.is_solved() ? value(result) : std::nullopt);
}

/// " from -3.2 to -2.7 in 7 cases".
std::string extent_of(const FinishedCases &cases, const CaseValue &quantity)
{
  std::vector<double> values;
  for (const auto &[index, result] : cases)
    if (const double value = value_in(cases, index, quantity); std::isfinite(value))
      values.push_back(value);
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  return fmt::format(FMT_STRING(" from {:.4g} to {:.4g} in {} cases"), *least, *most, values.size());
}

/// Whether there is something to see: values, and not all of them the same.
bool is_worth_drawing(const FinishedCases &cases, const CaseValue &quantity)
{
  std::vector<double> values;
  for (const auto &[index, result] : cases)
    if (const double value = value_in(cases, index, quantity); std::isfinite(value))
      values.push_back(value);
  if (values.empty())
    return false;
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  return *most - *least > 1e-9 * std::max(std::abs(*most), std::abs(*least));
}

/// Numbers of an entry of numbers.
std::vector<double> numbers_of(const SweptEntry &entry)
{
  std::vector<double> numbers;
  for (const std::string &value : entry.values)
    numbers.push_back(nan_where_missing(parse_number(value)));
  return numbers;
}

bool is_numeric(const SweptEntry &entry)
{
  return !entry.unit.empty() && entry.values.size() > 1;
}

/// The entries as the axis of curves and the one that tells curves apart, by their positions.
struct Roles
{
  std::size_t along = 0;
  std::optional<std::size_t> across;
};

/// Number of the case with these values.
std::size_t case_at(const SweepPlan &plan, const Roles &roles, std::size_t along, std::size_t across)
{
  if (!roles.across)
    return along;
  const std::size_t first = roles.along == 0 ? along : across;
  const std::size_t second = roles.along == 0 ? across : along;
  return first * plan.entries[1].values.size() + second;
}

/// A quantity over one entry, at the value @p across of the other.
std::vector<double> values_over(const SweepPlan &plan, const FinishedCases &cases, const Roles &roles,
                                std::size_t across, const CaseValue &value)
{
  std::vector<double> values;
  for (std::size_t i = 0; i < plan.entries[roles.along].values.size(); ++i)
    values.push_back(value_in(cases, case_at(plan, roles, i, across), value));
  return values;
}

/// A curve of a picture, at the value @p across of the entry that tells curves apart.
struct CaseCurve
{
  std::string title;
  CaseValue value;
  std::size_t across = 0;
  bool is_points = false; ///< which belong to the end of a list of curves
};

/// Curves over one entry, with gaps where they jump and where a spin changes its sign; an effect has those of
/// its two spins.
Plot curves_plot(const SweepPlan &plan, const FinishedCases &cases, const Roles &roles,
                 const Drawing &drawing, const std::vector<CaseCurve> &curves)
{
  const SweptEntry &along = plan.entries[roles.along];
  const std::vector<double> x = numbers_of(along);
  std::vector<std::string> titles;
  std::vector<Table> blocks;
  double n_points = 0;
  bool hides_change_of_sign = false;
  for (const CaseCurve &curve : curves)
  {
    const auto values = [&](const CaseValue &value)
    { return values_over(plan, cases, roles, curve.across, value); };
    const std::vector<double> y = values(curve.value);
    std::vector<std::vector<double>> spins;
    if (drawing.is_spin && !curve.is_points)
      spins = { y };
    if (drawing.is_effect)
      spins = { values(value_of("terminal spin")),
                values(value_of("terminal spin of the first harmonic alone")) };
    const CurveGaps gaps = gaps_of(y, spins);
    hides_change_of_sign = hides_change_of_sign || gaps.hides_change_of_sign;
    std::vector<std::vector<double>> rows;
    for (std::size_t i = 0; i < x.size(); ++i)
    {
      rows.push_back({ x[i], y[i] });
      if (!curve.is_points && i < gaps.at.size() && gaps.at[i])
        rows.push_back({ (x[i] + x[i + 1]) / 2, std::nan("") });
    }
    titles.push_back(curve.title);
    blocks.push_back(number_rows(curve.title.empty() ? drawing.caption : curve.title,
                                 { { name_of(along), along.unit }, { drawing.label, "1" } }, rows));
    n_points += curve.is_points;
  }
  Plot plot = plot_from("curves",
                        { { "x_label", label_of(along) },
                          { "y_label", drawing.label },
                          { "is_logarithmic", along.by_factors },
                          { "style", x.size() <= 30 ? "linespoints" : "lines" }, // few values are marked
                          { "curve", titles },
                          { "n_points", n_points } },
                        data_tables(blocks))
                .as(drawing.name, drawing.caption);
  if (hides_change_of_sign)
    plot.caption +=
      std::string(plot.caption.back() == '.' ? "" : ".") +
      " Points without a line: the spin changes its sign between them, and they are too far apart to "
      "tell how.";
  return plot;
}

/// A number to three digits, a word as it is.
std::string rounded(const std::string &value)
{
  const std::optional<double> number = parse_number(value);
  return number ? fmt::format(FMT_STRING("{:.3g}"), *number) : value;
}

/// A curve for each value of the other entry.
Plot family_plot(const SweepPlan &plan, const FinishedCases &cases, const Roles &roles,
                 const Drawing &drawing)
{
  std::vector<CaseCurve> curves;
  if (!roles.across)
    curves = { { "", drawing.value } };
  else
    for (const std::string &value : plan.entries[*roles.across].values)
      curves.push_back({ rounded(value), drawing.value, curves.size() });
  Plot plot = curves_plot(plan, cases, roles, drawing, curves);
  if (roles.across) // one legend for all pictures
    plot.script = "legend = 0\n" + plot.script;
  return plot;
}

/// The legend of family_plot(): its curves under the name of the entry and its unit.
Plot legend_of(const SweptEntry &entry)
{
  constexpr unsigned int n_columns = 4, width = 120, height = 24;
  nlohmann::ordered_json curves = nlohmann::ordered_json::array();
  std::string words;
  for (unsigned int i = 0; i < entry.values.size(); ++i)
  {
    const std::string text = rounded(entry.values[i]);
    curves.push_back({ { "type", 1 + i % 8 },
                       { "x", i % n_columns * width },
                       { "y", 46 + i / n_columns * height },
                       { "text", text } });
    words += (words.empty() ? "" : ", ") + text;
  }
  const auto n_rows = (entry.values.size() + n_columns - 1) / n_columns;
  return drawing_from("legend", { { "entry", label_of(entry) },
                                  { "curves", curves },
                                  { "words", words },
                                  { "height", 36 + n_rows * height } });
}

/// Terminal spins of the models side by side, over one entry.
Plot model_plot(const SweepPlan &plan, const FinishedCases &cases, Drawing drawing)
{
  drawing.caption =
    "Terminal spin under all harmonics of the load, under the first alone, and of a first harmonic on a ring "
    "of the contact radius. A curve is interrupted where it jumps.";
  std::vector<CaseCurve> curves = {
    { "all harmonics", drawing.value },
    { "first harmonic alone", value_of("terminal spin of the first harmonic alone") },
    { "first harmonic on a ring", value_of("terminal spin of the closure's first harmonic") }
  };
  const std::vector<double> falls = values_over(plan, cases, {}, 0, value_of(spin_of_fall));
  if (std::any_of(falls.begin(), falls.end(), [](double spin) { return std::isfinite(spin); }))
    curves.push_back({ "falls over at", value_of(spin_of_fall), 0, true });
  return curves_plot(plan, cases, {}, drawing, curves);
}

/// Where one cell of a map ends and the next begins: half-way between their values on the axis.
std::vector<double> cell_bounds(const std::vector<double> &values, bool logarithmic)
{
  const auto middle = [=](double a, double b) { return logarithmic ? std::sqrt(a * b) : (a + b) / 2; };
  const auto beyond = [=](double edge, double bound)
  { return logarithmic ? edge * edge / bound : 2 * edge - bound; };
  std::vector<double> bounds = { 0 };
  for (std::size_t i = 1; i < values.size(); ++i)
    bounds.push_back(middle(values[i - 1], values[i]));
  bounds.front() = beyond(values.front(), bounds[1]);
  bounds.push_back(beyond(values.back(), bounds.back()));
  return bounds;
}

Plot map_of(const SweepPlan &plan, const FinishedCases &cases, const Drawing &drawing)
{
  const SweptEntry &across = plan.entries[0], &up = plan.entries[1];
  const std::vector<double> x = numbers_of(across), y = numbers_of(up);
  const std::vector<double> x_bounds = cell_bounds(x, across.by_factors),
                            y_bounds = cell_bounds(y, up.by_factors);
  std::vector<std::vector<std::vector<double>>> lines(y.size());
  for (std::size_t j = 0; j < y.size(); ++j)
  {
    const std::vector<double> values = values_over(plan, cases, { 0, 1 }, j, drawing.value);
    for (std::size_t i = 0; i < x.size(); ++i)
      lines[j].push_back(
        { x[i], y[j], values[i], x_bounds[i], x_bounds[i + 1], y_bounds[j], y_bounds[j + 1] });
  }
  return plot_from("map",
                   { { "x_label", label_of(across) },
                     { "y_label", label_of(up) },
                     { "x_logarithmic", across.by_factors },
                     { "y_logarithmic", up.by_factors },
                     { "colour_label", drawing.label } },
                   grouped_data(drawing.caption,
                                { label_of(across), label_of(up), drawing.label, "left bound of the cell",
                                  "right bound", "lower bound", "upper bound" },
                                lines))
    .as(drawing.name, drawing.caption + ". White lines: where the scale has its numbers.");
}

} // namespace

std::string name_of(const SweptEntry &entry)
{
  return entry.path.substr(entry.path.find('/') + 1);
}

std::string label_of(const SweptEntry &entry)
{
  return with_unit(name_of(entry), entry.unit, false);
}

std::vector<Plot> grid_plots(const SweepPlan &plan, const FinishedCases &cases)
{
  constexpr std::size_t most_curves = 7, least_of_map = 4;
  const std::vector<SweptEntry> &entries = plan.entries;
  const bool has_two = entries.size() == 2;
  Roles roles;
  if (!is_numeric(entries[0]) ||
      (has_two && is_numeric(entries[1]) && entries[0].values.size() <= most_curves &&
       entries[0].values.size() < entries[1].values.size()))
    roles.along = has_two ? 1 : 0;
  if (!is_numeric(entries[roles.along]))
    return {};
  if (has_two)
    roles.across = 1 - roles.along;
  const std::size_t n_across = has_two ? entries[*roles.across].values.size() : 1;
  const bool as_map =
    has_two && is_numeric(entries[*roles.across]) &&
    (n_across > most_curves || std::min(n_across, entries[roles.along].values.size()) >= least_of_map);

  std::vector<Plot> plots;
  if (has_two && !as_map)
    plots.push_back(legend_of(entries[*roles.across]));
  const bool changes_sign = find_out(plan, cases).spin_changes_sign();
  for (const Drawing &drawing : drawings())
    if (!is_worth_drawing(cases, drawing.value) || (changes_sign && drawing.name == "harmonic_effect"))
      continue;
    else
    {
      plots.push_back(as_map ? map_of(plan, cases, drawing)
                      : !has_two && drawing.name == "terminal_spin"
                        ? model_plot(plan, cases, drawing)
                        : family_plot(plan, cases, roles, drawing));
      plots.back().label = drawing.label + extent_of(cases, drawing.value);
    }
  if (std::any_of(cases.begin(), cases.end(), [](const auto &one) { return one.second.falls_over(); }))
    for (Plot &plot : plots)
      plot.caption += " Where a case has no terminal spin, the glass falls over on the way.";
  return plots;
}

} // namespace stemware::pipeline
