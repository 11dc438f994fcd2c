#include "fem/pipeline/analysis/sweep/curve_gaps.h"
#include "fem/pipeline/report/plots/plots.h"
#include "fem/pipeline/report/render/table_renderers.h"
#include "fem/pipeline/support/numbers.h"

#include <algorithm>
#include <cmath>

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

bool is_numeric(const SweptEntry &entry)
{
  return !entry.unit.empty() && entry.values.size() > 1;
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

/// Something to draw: a quantity of the table, or a harmonic's amplitude.
struct Drawing
{
  std::string name;  ///< of the plot
  std::string label; ///< of the axis, with its unit
  std::string caption;
  Values values;
};

/// A curve of a picture. Its gaps are its own jumps and those of the spins that it shows or is computed from.
struct CaseCurve
{
  std::string title;
  Values values;
  std::vector<Values> spins = {};
  bool is_points = false; ///< which belong to the end of a list of curves
};

/// The pictures of a grid of one or two entries.
class Grid
{
public:
  Grid(const SweepPlan &plan, const FinishedCases &cases)
      : entries(plan.entries)
      , cases(cases)
      , n_cases(plan.cases.size())
      , has_two(plan.entries.size() == 2)
  {
    constexpr std::size_t most_curves = 7, least_of_map = 4;
    const auto n = [&](std::size_t i) { return entries[i].values.size(); };
    const bool are_numeric = has_two && is_numeric(entries[0]) && is_numeric(entries[1]);
    if (has_two && (!is_numeric(entries[0]) || (are_numeric && n(0) <= most_curves && n(0) < n(1))))
      along = 1;
    is_map = are_numeric && (n(1 - along) > most_curves || std::min(n(0), n(1)) >= least_of_map);
  }

  bool can_be_drawn() const { return is_numeric(entries[along]); }
  bool has_legend() const { return has_two && !is_map; }

  /// Things to draw that have values, and not the same in all cases.
  std::vector<Drawing> drawings() const
  {
    std::vector<Drawing> all = {
      { "terminal_spin", heading_with_unit(quantity_named("omega_terminal")),
        "Terminal spin under all harmonics of the load", values_of("terminal spin") },
      { "absolute_harmonic_effect", "harmonic effect (rad/s)",
        "What the harmonics of the load beyond the first add to the terminal spin",
        values_of("absolute harmonic effect") },
      { "harmonic_effect", "harmonic effect (%)",
        "How much faster the harmonics of the load beyond the first make the glass",
        values_of("harmonic effect") },
      { "second_harmonic", "√(a_2² + b_2²) / a_0", "Amplitude of the load's second harmonic over its mean",
        amplitudes("2/a_0") },
      { "third_harmonic", "√(a_3² + b_3²) / a_0", "Amplitude of the load's third harmonic over its mean",
        amplitudes("3/a_0") },
      { "contact_fraction", "share of the rim that carries load", "Share of the rim that carries load",
        values_of("contact fraction") },
      { "torque_at_rest", "τ_z at rest (mN m)", "Torque of friction on the glass that does not spin yet",
        values_of("torque at rest", 1e3) }
    };
    const auto is_dull = [](const Drawing &drawing)
    {
      const Values found = finite(drawing.values);
      const auto [least, most] = std::minmax_element(found.begin(), found.end());
      return found.empty() || !(*most - *least > 1e-9 * std::max(std::abs(*most), std::abs(*least)));
    };
    all.erase(std::remove_if(all.begin(), all.end(), is_dull), all.end());
    return all;
  }

  void add(const Drawing &drawing, Document &document) const
  {
    const Values found = finite(drawing.values);
    const auto [least, most] = std::minmax_element(found.begin(), found.end());
    const std::string words = fmt::format(FMT_STRING("{} from {:.4g} to {:.4g} in {} cases"), drawing.label,
                                          *least, *most, found.size());
    if (is_map)
      add_map(drawing, words, document);
    else
      add_curves(drawing, words, document);
  }

  /// The names of the curves under that of the entry which tells them apart.
  Json legend() const
  {
    constexpr unsigned int n_columns = 4, width = 120, height = 24;
    const SweptEntry &entry = entries[1 - along];
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
    return { { "entry", label_of(entry) },
             { "curves", curves },
             { "words", words },
             { "height", 36 + n_rows * height } };
  }

private:
  static Values finite(Values values)
  {
    values.erase(
      std::remove_if(values.begin(), values.end(), [](double value) { return !std::isfinite(value); }),
      values.end());
    return values;
  }

  Values values_of(const std::string &quantity, double scale = 1) const
  {
    Values values(n_cases, std::nan(""));
    for (const auto &[index, result] : cases)
      if (const auto q = quantity_index(quantity); result.is_solved() && result.values[q])
        values[index] = scale * *result.values[q];
    return values;
  }

  Values amplitudes(const std::string &tail) const
  {
    Values a = values_of("a_" + tail);
    const Values b = values_of("b_" + tail);
    std::transform(a.begin(), a.end(), b.begin(), a.begin(),
                   [](double x, double y) { return std::hypot(x, y); });
    return a;
  }

  /// The values over the entry along the axis, at the value @p across of the other.
  Values cut(const Values &values, std::size_t across) const
  {
    Values line;
    for (std::size_t i = 0; i < entries[along].values.size(); ++i)
      line.push_back(!has_two     ? values[i]
                     : along == 0 ? values[i * entries[1].values.size() + across]
                                  : values[across * entries[1].values.size() + i]);
    return line;
  }

  std::vector<CaseCurve> curves_of(const Drawing &drawing) const
  {
    const bool is_spin = drawing.name == "terminal_spin";
    std::vector<Values> spins;
    if (is_spin)
      spins = { drawing.values };
    else if (drawing.name.find("harmonic_effect") != std::string::npos) // a difference of two spins
      spins = { values_of("terminal spin"), values_of("terminal spin of the first harmonic alone") };
    std::vector<CaseCurve> curves;
    if (!has_two && is_spin)
    {
      curves = { { "all harmonics", drawing.values },
                 { "first harmonic alone", values_of("terminal spin of the first harmonic alone") },
                 { "first harmonic on a ring", values_of("terminal spin of the closure's first harmonic") } };
      for (CaseCurve &curve : curves)
        curve.spins = { curve.values };
      if (const Values falls = values_of(spin_of_fall); !finite(falls).empty())
        curves.push_back({ "falls over at", falls, {}, true });
    }
    else if (!has_two)
      curves = { { "", drawing.values, spins } };
    for (std::size_t i = 0; has_two && i < entries[1 - along].values.size(); ++i)
    {
      curves.push_back({ rounded(entries[1 - along].values[i]), cut(drawing.values, i) });
      for (const Values &spin : spins)
        curves.back().spins.push_back(cut(spin, i));
    }
    return curves;
  }

  /// Curves over one entry, with gaps where they jump and where a spin changes its sign.
  void add_curves(const Drawing &drawing, const std::string &words, Document &document) const
  {
    const SweptEntry &axis = entries[along];
    const Values x = numbers_of(axis);
    std::string caption = drawing.caption;
    if (!has_two && drawing.name == "terminal_spin")
      caption +=
        ", under the first alone, and of a first harmonic on a ring of the contact radius. A curve is "
        "interrupted where it jumps.";
    Json titles = Json::array();
    std::vector<Table> blocks;
    double n_points = 0;
    bool hides_change_of_sign = false;
    for (const CaseCurve &curve : curves_of(drawing))
    {
      const CurveGaps gaps = gaps_of(curve.values, curve.spins);
      hides_change_of_sign = hides_change_of_sign || gaps.hides_change_of_sign;
      std::vector<std::vector<double>> rows;
      for (std::size_t i = 0; i < x.size(); ++i)
      {
        rows.push_back({ x[i], curve.values[i] });
        if (!curve.is_points && i < gaps.at.size() && gaps.at[i])
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
                  { "has_legend", has_legend() } },
                data_tables(blocks), document);
  }

  void add_map(const Drawing &drawing, const std::string &words, Document &document) const
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

  const std::vector<SweptEntry> &entries;
  const FinishedCases &cases;
  const std::size_t n_cases;
  const bool has_two;
  std::size_t along = 0; ///< the entry along the axis of curves
  bool is_map = false;
};

// ---- random samples

/// How the samples of a quantity are distributed, which entries it depends on, and all of them over the one
/// that the linear fit depends on most.
void add_samples(const SweepPlan &plan, const FinishedCases &cases, const std::string &name,
                 const QuantityFindings &about, Document &document)
{
  const SweepQuantity &quantity = about.quantity();
  const std::string label = with_unit(quantity.name, quantity.unit);
  const std::vector<double> &weights = about.sensitivity->regression;
  std::vector<std::size_t> order; // entries from the weakest to the strongest
  for (std::size_t i = 0; i < weights.size(); ++i)
    order.push_back(i);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t i, std::size_t j) { return std::abs(weights[i]) < std::abs(weights[j]); });
  const std::size_t strongest =
    static_cast<std::size_t>(std::max_element(weights.begin(), weights.end(),
                                              [](double a, double b) { return std::abs(a) < std::abs(b); }) -
                             weights.begin());
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
    if (result.is_solved() && result.values[about.index])
      rows.push_back({ parse_number(plan.cases[index][strongest]).value(), *result.values[about.index] });
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
  if (plan.is_random())
  {
    for (const auto &[name, quantity] :
         { std::pair("terminal_spin", "terminal spin"), std::pair("harmonic_effect", "harmonic effect") })
      if (const QuantityFindings *about = findings.about(quantity);
          about != nullptr && about->sensitivity) // else nothing varies
        add_samples(plan, cases, name, *about, document);
    return;
  }
  const Grid grid(plan, cases);
  if (!grid.can_be_drawn())
    return;
  if (grid.has_legend())
    document.facts["legend"] = grid.legend();
  for (const Drawing &drawing : grid.drawings())
    if (drawing.name != "harmonic_effect" || !findings.spin_changes_sign())
      grid.add(drawing, document);
}

} // namespace stemware::pipeline
