#include "fem/pipeline/output/plots/plots.h"
#include "fem/pipeline/output/quantities.h"
#include "fem/pipeline/output/render/plot_script.h"
#include "fem/pipeline/support/numbers.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

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

CaseValue value_of(const std::string &quantity)
{
  return [index = quantity_index(quantity)](const CaseResult &result) { return result.values[index]; };
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
           { "torque_at_rest", heading_with_unit(quantity::tau_at_rest),
             "Torque of friction on the glass that does not spin yet", value_of("torque at rest") } };
}

double nan_where_missing(const std::optional<double> &value)
{
  return value.value_or(std::numeric_limits<double>::quiet_NaN());
}

double value_in(const FinishedCases &cases, std::size_t index, const CaseValue &value)
{
  const CaseResult &result = cases.at(index);
  return nan_where_missing(result.is_solved() ? value(result) : std::nullopt);
}

/// Whether there is something to see: values, and not all of them the same.
bool is_worth_drawing(const FinishedCases &cases, const CaseValue &quantity)
{
  Extent values;
  for (const auto &[index, result] : cases)
    values.include(value_in(cases, index, quantity));
  return values.most - values.least > 1e-9 * std::max(std::abs(values.most), std::abs(values.least));
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

/// Few values are marked.
CurveStyle style_of(std::size_t n_values)
{
  return n_values <= 30 ? CurveStyle::line_and_points : CurveStyle::line;
}

/// Intervals between the values of a curve in which it jumps: one of them, or two side by side, over which
/// the curve changes more than four times as much as over those to their left and right.
std::vector<bool> jumps_of(const std::vector<double> &y)
{
  constexpr double factor = 4;
  std::vector<double> steps;
  for (std::size_t i = 0; i + 1 < y.size(); ++i)
    steps.push_back(std::abs(y[i + 1] - y[i]));
  std::vector<bool> jumps(steps.size(), false);
  for (const std::ptrdiff_t width : { 1, 2 })
    for (std::size_t i = 1; i + static_cast<std::size_t>(width) < steps.size(); ++i)
    {
      const auto first = steps.begin() + static_cast<std::ptrdiff_t>(i), last = first + width;
      if (!std::all_of(first - 1, last + 1, [](double step) { return std::isfinite(step); }))
        continue; // beside a case that has failed
      const double smallest = *std::min_element(first, last), beside = std::max(*(first - 1), *last);
      if (smallest > factor * beside && beside > 1e-9 * smallest) // rounding beside a step tells nothing
        std::fill_n(jumps.begin() + static_cast<std::ptrdiff_t>(i), width, true);
    }
  return jumps;
}

/// Intervals in which a spin changes its sign, together with the values between that are zero, where they are
/// too wide to tell how: the curve changes more than four times as much there as over the intervals beside,
/// or there are none beside.
std::vector<bool> unresolved_changes_of_sign(const std::vector<double> &y)
{
  constexpr double factor = 4;
  std::vector<bool> unresolved(y.empty() ? 0 : y.size() - 1, false);
  double largest = 0;
  for (const double value : y)
    largest = std::isfinite(value) ? std::max(largest, std::abs(value)) : largest;
  const auto is_zero = [&](std::size_t i) { return std::abs(y[i]) <= 1e-9 * largest; };
  const auto step = [&](std::size_t i) { return std::abs(y[i + 1] - y[i]); };
  for (std::size_t first = 0; first + 1 < y.size(); ++first)
  {
    std::size_t last = first + 1;
    while (last + 1 < y.size() && is_zero(last))
      ++last;
    if (is_zero(first) || !(y[first] * y[last] < 0))
      continue;
    double beside = 0, smallest = step(first);
    for (std::size_t i = first; i < last; ++i)
      smallest = std::min(smallest, step(i));
    if (first > 0 && std::isfinite(step(first - 1)))
      beside = step(first - 1);
    if (last + 1 < y.size() && std::isfinite(step(last)))
      beside = std::max(beside, step(last));
    if (smallest > factor * beside)
      std::fill(unresolved.begin() + static_cast<std::ptrdiff_t>(first),
                unresolved.begin() + static_cast<std::ptrdiff_t>(last), true);
  }
  return unresolved;
}

/// The curve with a gap in each of the intervals.
Curve broken(const Curve &whole, const std::vector<bool> &jumps)
{
  Curve curve = whole;
  curve.x.clear();
  curve.y.clear();
  for (std::size_t i = 0; i < whole.x.size(); ++i)
  {
    curve.add(whole.x[i], whole.y[i]);
    if (i < jumps.size() && jumps[i])
      curve.add((whole.x[i] + whole.x[i + 1]) / 2, std::numeric_limits<double>::quiet_NaN());
  }
  return curve;
}

/// A quantity over one entry, at the value @p across of the other.
Curve curve_over(const SweepPlan &plan, const FinishedCases &cases, const Roles &roles, std::size_t across,
                 const CaseValue &value)
{
  Curve curve;
  std::size_t i = 0;
  for (const double x : numbers_of(plan.entries[roles.along]))
    curve.add(x, value_in(cases, case_at(plan, roles, i++, across), value));
  return curve;
}

/// A curve with gaps where it jumps, and where a spin changes its sign; an effect has those of its two spins.
/// Says in @p caption where there is a gap of the second kind.
Curve broken_curve(const SweepPlan &plan, const FinishedCases &cases, const Roles &roles, std::size_t across,
                   const Drawing &drawing, std::string &caption)
{
  const Curve whole = curve_over(plan, cases, roles, across, drawing.value);
  std::vector<bool> jumps = jumps_of(whole.y);
  const auto add = [&](const std::vector<bool> &more)
  { std::transform(jumps.begin(), jumps.end(), more.begin(), jumps.begin(), std::logical_or<>()); };
  std::vector<std::vector<double>> spins;
  if (drawing.is_spin)
    spins = { whole.y };
  if (drawing.is_effect)
    for (const char *spin : { "terminal spin", "terminal spin of the first harmonic alone" })
      spins.push_back(curve_over(plan, cases, roles, across, value_of(spin)).y);
  const std::string remark =
    " Points without a line: the spin changes its sign between them, and they are too "
    "far apart to tell how.";
  for (const std::vector<double> &spin : spins)
  {
    const std::vector<bool> unresolved = unresolved_changes_of_sign(spin);
    add(jumps_of(spin));
    add(unresolved);
    if (std::find(unresolved.begin(), unresolved.end(), true) != unresolved.end() &&
        caption.find(remark) == std::string::npos)
      caption += (caption.back() == '.' ? "" : ".") + remark;
  }
  return broken(whole, jumps);
}

Plot family_plot(const SweepPlan &plan, const FinishedCases &cases, const Roles &roles,
                 const Drawing &drawing)
{
  CurvePlot plot = {
    drawing.name, drawing.caption, axis_of(plan.entries[roles.along]), { drawing.label }, {}
  };
  const std::size_t n_curves = roles.across ? plan.entries[*roles.across].values.size() : 1;
  for (std::size_t across = 0; across < n_curves; ++across)
  {
    Curve curve = broken_curve(plan, cases, roles, across, drawing, plot.caption);
    if (roles.across)
      curve.title =
        axis_of(plan.entries[*roles.across]).label + " = " + plan.entries[*roles.across].values[across];
    curve.style = style_of(plan.entries[roles.along].values.size());
    plot.curves.push_back(curve);
  }
  return curve_plot(plot);
}

/// Terminal spins of the models side by side, over one entry.
Plot model_plot(const SweepPlan &plan, const FinishedCases &cases)
{
  CurvePlot plot = {
    "terminal_spin",
    "Terminal spin under all harmonics of the load, under the first alone, and of a first harmonic on a ring "
    "of the contact radius. A curve is interrupted where it jumps.",
    axis_of(plan.entries[0]),
    { heading_with_unit(quantity::omega_terminal) },
    {}
  };
  for (const auto &[title, quantity] :
       { std::pair("all harmonics", "terminal spin"),
         std::pair("first harmonic alone", "terminal spin of the first harmonic alone"),
         std::pair("first harmonic on a ring", "terminal spin of the closure's first harmonic") })
  {
    plot.curves.push_back(
      broken_curve(plan, cases, {}, 0, { "", "", "", value_of(quantity), false, true }, plot.caption));
    plot.curves.back().title = title;
    plot.curves.back().style = style_of(plan.entries[0].values.size());
  }
  Curve falls = curve_over(plan, cases, {}, 0, value_of(spin_of_fall));
  if (std::any_of(falls.y.begin(), falls.y.end(), [](double spin) { return std::isfinite(spin); }))
  {
    falls.title = "falls over at";
    falls.style = CurveStyle::points;
    plot.curves.push_back(falls);
  }
  return curve_plot(plot);
}

Plot map_of(const SweepPlan &plan, const FinishedCases &cases, const Drawing &drawing)
{
  ValueMap map = { drawing.name,
                   drawing.caption,
                   axis_of(plan.entries[0]),
                   axis_of(plan.entries[1]),
                   drawing.label,
                   numbers_of(plan.entries[0]),
                   numbers_of(plan.entries[1]),
                   {} };
  const Roles roles = { 0, 1 };
  for (std::size_t j = 0; j < map.y_values.size(); ++j)
    map.values.push_back(curve_over(plan, cases, roles, j, drawing.value).y);
  return map_plot(map);
}

} // namespace

std::string name_of(const SweptEntry &entry)
{
  return entry.path.substr(entry.path.find('/') + 1);
}

Axis axis_of(const SweptEntry &entry)
{
  return { with_unit(name_of(entry), entry.unit, false), entry.by_factors };
}

std::vector<Plot> grid_plots(const SweepPlan &plan, const FinishedCases &cases)
{
  constexpr std::size_t most_curves = 7;
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
  const bool as_map =
    has_two && is_numeric(entries[*roles.across]) && entries[*roles.across].values.size() > most_curves;

  std::vector<Plot> plots;
  const bool changes_sign = find_out(plan, cases).spin_changes_sign();
  for (const Drawing &drawing : drawings())
    if (!is_worth_drawing(cases, drawing.value) || (changes_sign && drawing.name == "harmonic_effect"))
      continue;
    else if (as_map)
      plots.push_back(map_of(plan, cases, drawing));
    else if (!has_two && drawing.name == "terminal_spin")
      plots.push_back(model_plot(plan, cases));
    else
      plots.push_back(family_plot(plan, cases, roles, drawing));
  if (std::any_of(cases.begin(), cases.end(), [](const auto &one) { return one.second.falls_over(); }))
    for (Plot &plot : plots)
      plot.caption += " Where a case has no terminal spin, the glass falls over on the way.";
  return plots;
}

} // namespace stemware::pipeline
