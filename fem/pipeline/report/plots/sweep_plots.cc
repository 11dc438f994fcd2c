#include "fem/pipeline/analysis/sweep/grid_view.h"
#include "fem/pipeline/report/plot.h"
#include "fem/pipeline/report/plots/plots.h"
#include "fem/pipeline/report/render/table_renderers.h"
#include "fem/pipeline/support/numbers.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace stemware::pipeline
{

namespace
{

using Json = nlohmann::ordered_json;
using Values = std::vector<double>; ///< of a quantity in all cases, in their order; NaN where there is none

std::string name_of(const SweptEntry &entry)
{
  return entry.path.substr(entry.path.find('/') + 1);
}

std::string label_of(const SweptEntry &entry)
{
  return with_unit(name_of(entry), entry.unit, false);
}

/// Numbers of an entry of numbers.
Values numbers_of(const SweptEntry &entry)
{
  Values numbers;
  for (const std::string &value : entry.values)
    numbers.push_back(parse_number(value).value_or(std::nan("")));
  return numbers;
}

/// A number to three digits, a word as it is.
std::string rounded(const std::string &value)
{
  const std::optional<double> number = parse_number(value);
  return number ? fmt::format(FMT_STRING("{:.3g}"), *number) : value;
}

/// A picture for the report, with what its template asks for.
void add_picture(const std::string &name, const std::string &source, const std::string &words,
                 const Json &values, const std::string &data, Document &document)
{
  document.facts["pictures"].push_back({ { "name", name }, { "source", source }, { "words", words } });
  document.plots[name] = values;
  document.texts["sweep_" + name] = data;
}

// ---- grids

Values values_of(const FinishedCases &cases, const std::string &quantity)
{
  const std::size_t index = quantity_index(quantity);
  Values values;
  for (const auto &[number, result] : cases)
    values.push_back(result.value(index).value_or(std::nan("")));
  return values;
}

/// sqrt(a_n^2 + b_n^2) / a_0 of the harmonic @p n.
Values amplitudes_of(const FinishedCases &cases, const std::string &n)
{
  Values a = values_of(cases, "a_" + n + "/a_0");
  const Values b = values_of(cases, "b_" + n + "/a_0");
  std::transform(a.begin(), a.end(), b.begin(), a.begin(),
                 [](double x, double y) { return std::hypot(x, y); });
  return a;
}

/// Something to draw: a quantity of the table, or a harmonic's amplitude.
struct Drawing
{
  std::string name;  ///< of the plot
  std::string label; ///< of the axis, with its unit
  std::string caption;
  Values values;
  std::vector<Values> spins = {}; ///< that it shows or is computed from
};

std::vector<Drawing> drawings_of(const FinishedCases &cases)
{
  const Values spin = values_of(cases, "terminal spin");
  const std::vector<Values> own = { spin },
                            both = { spin, values_of(cases, "terminal spin of the first harmonic alone") };
  Values torque = values_of(cases, "torque at rest");
  for (double &value : torque)
    value *= 1e3;
  return { { "terminal_spin", heading_with_unit(quantity_named("omega_terminal")),
             "Terminal spin under all harmonics of the load", spin, own },
           { "absolute_harmonic_effect", "harmonic effect (rad/s)",
             "What the harmonics of the load beyond the first add to the terminal spin",
             values_of(cases, "absolute harmonic effect"), both },
           { "harmonic_effect", "harmonic effect (%)",
             "How much faster the harmonics of the load beyond the first make the glass",
             values_of(cases, "harmonic effect"), both },
           { "second_harmonic", "√(a_2² + b_2²) / a_0",
             "Amplitude of the load's second harmonic over its mean", amplitudes_of(cases, "2") },
           { "third_harmonic", "√(a_3² + b_3²) / a_0", "Amplitude of the load's third harmonic over its mean",
             amplitudes_of(cases, "3") },
           { "contact_fraction", "share of the rim that carries load", "Share of the rim that carries load",
             values_of(cases, "contact fraction") },
           { "torque_at_rest", "τ_z at rest (mN m)", "Torque of friction on the glass that does not spin yet",
             torque } };
}

/// A curve of a picture. Its gaps are its own jumps and those of the spins that it shows or is computed from.
struct CaseCurve
{
  std::string title;
  Values values;
  std::vector<Values> spins = {};
  bool is_points = false; ///< which belong to the end of a list of curves
};

/// The models whose terminal spins a sweep of one entry shows in one picture.
std::vector<CaseCurve> spin_curves(const FinishedCases &cases)
{
  std::vector<CaseCurve> curves = {
    { "all harmonics", values_of(cases, "terminal spin") },
    { "first harmonic alone", values_of(cases, "terminal spin of the first harmonic alone") },
    { "first harmonic on a ring", values_of(cases, "terminal spin of the closure's first harmonic") }
  };
  for (CaseCurve &curve : curves)
    curve.spins = { curve.values };
  if (std::any_of(cases.begin(), cases.end(), [](const auto &one) { return one.second.falls_over(); }))
    curves.push_back({ "falls over at", values_of(cases, spin_of_fall), {}, true });
  return curves;
}

std::vector<CaseCurve> curves_of(const SweepPlan &plan, const GridView &view, const Drawing &drawing)
{
  std::vector<CaseCurve> curves;
  for (std::size_t i = 0; i < view.n_curves; ++i)
  {
    curves.push_back(
      { view.has_two ? rounded(plan.entries[1 - view.along].values[i]) : "", view.curve(drawing.values, i) });
    for (const Values &spin : drawing.spins)
      curves.back().spins.push_back(view.curve(spin, i));
  }
  return curves;
}

/// Curves over one entry, with gaps where they jump and where a spin changes its sign.
void add_curves(const SweptEntry &axis, const std::vector<CaseCurve> &curves, const Drawing &drawing,
                const std::string &words, bool has_legend, Document &document)
{
  const Values x = numbers_of(axis);
  std::string caption = drawing.caption;
  Json titles = Json::array();
  std::vector<Table> blocks;
  double n_points = 0;
  bool hides_change_of_sign = false;
  for (const CaseCurve &curve : curves)
  {
    const CurveGaps gaps = gaps_of(curve.values, curve.spins);
    hides_change_of_sign = hides_change_of_sign || gaps.hides_change_of_sign;
    std::vector<std::vector<double>> rows;
    for (std::size_t i = 0; i < x.size(); ++i)
    {
      rows.push_back({ x[i], curve.values[i] });
      if (!curve.is_points && gaps.at[i])
        rows.push_back({ (x[i] + x[i + 1]) / 2, std::nan("") });
    }
    titles.push_back(curve.title);
    blocks.push_back(number_rows(curve.title.empty() ? caption : curve.title,
                                 { { name_of(axis), axis.unit }, { drawing.label, "1" } }, rows));
    n_points += curve.is_points;
  }
  if (hides_change_of_sign)
    caption += std::string(caption.back() == '.' ? "" : ".") +
               " Points without a line: the spin changes its sign between them, and they are too far apart "
               "to tell how.";
  add_picture(drawing.name, "curves", words,
              { { "caption", caption },
                { "x_label", label_of(axis) },
                { "y_label", drawing.label },
                { "is_logarithmic", axis.by_factors },
                { "style", x.size() <= 30 ? "linespoints" : "lines" }, // few values are marked
                { "curve", titles },
                { "n_points", n_points },
                { "has_legend", has_legend } },
              data_tables(blocks), document);
}

void add_map(const std::vector<SweptEntry> &entries, const Drawing &drawing, const std::string &words,
             Document &document)
{
  const Values x = numbers_of(entries[0]), y = numbers_of(entries[1]);
  std::vector<std::vector<std::vector<double>>> lines(y.size());
  for (std::size_t j = 0; j < y.size(); ++j)
    for (std::size_t i = 0; i < x.size(); ++i)
      lines[j].push_back({ x[i], y[j], drawing.values[i * y.size() + j] });
  const std::string x_label = label_of(entries[0]), y_label = label_of(entries[1]);
  add_picture(drawing.name, "map", words,
              { { "caption", drawing.caption },
                { "x_label", x_label },
                { "y_label", y_label },
                { "x_at", x },
                { "y_at", y },
                { "x_logarithmic", entries[0].by_factors },
                { "y_logarithmic", entries[1].by_factors },
                { "colour_label", drawing.label } },
              grouped_data(drawing.caption, { x_label, y_label, drawing.label }, lines), document);
}

/// The names of the curves under that of the @p entry which tells them apart.
Json legend_of(const SweptEntry &entry)
{
  constexpr unsigned int n_columns = 4, width = 120, height = 24;
  Json curves = Json::array();
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
  return {
    { "entry", label_of(entry) }, { "curves", curves }, { "words", words }, { "height", 36 + n_rows * height }
  };
}

/// The pictures of a grid: of what has values, and not the same in all cases.
void add_grid(const SweepPlan &plan, const FinishedCases &cases, bool spin_changes_sign, Document &document)
{
  const GridView view(plan);
  if (!view.can_be_drawn)
    return;
  const bool has_legend = view.has_two && !view.is_map;
  if (has_legend)
    document.facts["legend"] = legend_of(plan.entries[1 - view.along]);
  for (Drawing drawing : drawings_of(cases))
  {
    Values found = drawing.values;
    found.erase(
      std::remove_if(found.begin(), found.end(), [](double value) { return !std::isfinite(value); }),
      found.end());
    const auto [least, most] = std::minmax_element(found.begin(), found.end());
    if (found.empty() || !(*most - *least > 1e-9 * std::max(std::abs(*most), std::abs(*least))) ||
        (spin_changes_sign && drawing.name == "harmonic_effect"))
      continue;
    const std::string words = fmt::format(FMT_STRING("{} from {:.4g} to {:.4g} in {} cases"), drawing.label,
                                          *least, *most, found.size());
    const bool shows_models = !view.has_two && drawing.name == "terminal_spin";
    if (shows_models)
      drawing.caption +=
        ", under the first alone, and of a first harmonic on a ring of the contact radius. A "
        "curve is interrupted where it jumps.";
    if (view.is_map)
      add_map(plan.entries, drawing, words, document);
    else
      add_curves(plan.entries[view.along], shows_models ? spin_curves(cases) : curves_of(plan, view, drawing),
                 drawing, words, has_legend, document);
  }
}

// ---- random samples

/// How the samples of a quantity are distributed, which entries it depends on, and all of them over the one
/// that the linear fit depends on most.
void add_samples(const SweepPlan &plan, const FinishedCases &cases, const std::string &name,
                 const QuantityFindings &about, Document &document)
{
  const SweepQuantity &quantity = about.quantity();
  const std::string label = with_unit(quantity.name, quantity.unit);
  const std::vector<double> &weights = about.sensitivity->regression;
  std::vector<std::size_t> order(weights.size()); // entries from the weakest to the strongest
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t i, std::size_t j) { return std::abs(weights[i]) < std::abs(weights[j]); });
  const std::size_t strongest =
    *std::find_if(order.begin(), order.end(),
                  [&](std::size_t i) { return std::abs(weights[i]) == std::abs(weights[order.back()]); });
  const SweptEntry &along = plan.entries[strongest];
  std::vector<std::string> names;
  std::vector<double> changes;
  for (const std::size_t i : order)
  {
    names.push_back(name_of(plan.entries[i]));
    changes.push_back(weights[i] * about.band->deviation);
  }
  std::vector<std::vector<double>> rows;
  for (const auto &[index, result] : cases)
    if (const auto value = result.value(about.index))
      rows.push_back({ parse_number(plan.cases[index][strongest]).value(), *value });
  add_picture(name + "_histogram", "histogram", "",
              { { "x_label", label }, { "what", quantity.name }, { "samples", name + "_samples" } }, "",
              document);
  add_picture(name + "_tornado", "tornado", "",
              { { "x_label", "change of " + label }, { "what", quantity.name }, { "row", names } },
              data_table({ "Change of the " + quantity.name + ", from below",
                           { numbers("change when a parameter goes up", quantity.unit, changes) } }),
              document);
  add_picture(
    name + "_samples", "curves", "",
    { { "caption", "All samples over the parameter that the linear fit depends on most: " + quantity.name },
      { "x_label", label_of(along) },
      { "y_label", label },
      { "is_logarithmic", along.by_factors },
      { "style", "points" },
      { "curve", { "" } },
      { "n_points", 0 },
      { "has_legend", false } },
    data_table(
      number_rows("Samples", { { name_of(along), along.unit }, { quantity.name, quantity.unit } }, rows)),
    document);
}

} // namespace

void add_sweep_plots(const SweepPlan &plan, const FinishedCases &cases, const SweepFindings &findings,
                     Document &document)
{
  document.facts["pictures"] = Json::array();
  document.facts["legend"] = nullptr;
  document.facts["falls_over"] =
    !plan.is_random() &&
    std::any_of(cases.begin(), cases.end(), [](const auto &one) { return one.second.falls_over(); });
  if (!plan.is_random())
    add_grid(plan, cases, findings.spin_changes_sign(), document);
  for (const auto &[name, quantity] :
       { std::pair("terminal_spin", "terminal spin"), std::pair("harmonic_effect", "harmonic effect") })
    if (const QuantityFindings *about = findings.about(quantity);
        about != nullptr && about->sensitivity) // of random samples; else nothing varies
      add_samples(plan, cases, name, *about, document);
}

} // namespace stemware::pipeline
