#include "fem/pipeline/report/picture_columns.h"
#include "fem/pipeline/support/failures.h"
#include "fem/pipeline/support/numbers.h"

#include <algorithm>
#include <cmath>

namespace stemware::pipeline
{

namespace
{

using Json = nlohmann::ordered_json;
using Values = std::vector<double>; ///< of a quantity in all cases of a grid; NaN in cases without one

/// Roles of the entries of a grid: one along the axis of curves, the other tells them apart or is the second
/// axis of a map.
struct GridView
{
  explicit GridView(const CaseList &list)
      : has_two(list.entries.size() == 2)
  {
    constexpr std::size_t max_curves = 7, min_of_map = 4;
    const auto has_numbers = [](const VariedEntry &entry)
    { return !entry.unit.empty() && entry.values.size() > 1; };
    const VariedEntry &first = list.entries.front(), &last = list.entries.back();
    const std::size_t n_first = first.values.size(), n_last = last.values.size();
    const bool all_numbers = has_two && has_numbers(first) && has_numbers(last);
    if (has_two && (!has_numbers(first) || (all_numbers && n_first <= max_curves && n_first < n_last)))
      along = 1;
    can_be_drawn = has_numbers(list.entries[along]);
    is_map = all_numbers && std::min(n_first, n_last) >= min_of_map;
  }

  std::size_t along = 0; ///< entry along the axis of curves
  bool has_two, is_map = false, can_be_drawn = false;
};

std::string label_of(const VariedEntry &entry)
{
  return with_unit(entry.path.substr(entry.path.find('/') + 1), entry.unit, false);
}

Values numbers_of(const VariedEntry &entry)
{
  Values numbers;
  for (const std::string &value : entry.values)
    numbers.push_back(parse_number(value).value_or(std::nan("")));
  return numbers;
}

Values values_of(const CaseList &list, const FinishedCases &finished, const std::string &key)
{
  Values values(list.cases.size(), std::nan(""));
  for (const auto &[index, result] : finished)
    values[index] = result.value(key).value_or(std::nan(""));
  return values;
}

/// Picture of a quantity.
struct Drawing
{
  std::string key, caption;
  Values values;
  std::string label = heading_with_unit(quantity_named(key, "sweep.csv"));
};

/// Curve of a picture.
struct GridCurve
{
  std::string title;
  Values values;
};

/// True if a curve jumps between values @p i and i + 1: each of one or two neighbouring intervals, this one
/// among them, has more than four times the change of the intervals to their left and right. (A spin that
/// changes its sense has a zero in the middle of its jump.) No line is drawn over a jump.
bool jumps(const Values &y, std::size_t i)
{
  constexpr double factor = 4;
  const auto step = [&](std::size_t j) { return std::abs(y[j + 1] - y[j]); };
  const auto jumps_over = [&](std::size_t first, std::size_t n_intervals)
  {
    const std::size_t end = first + n_intervals;
    if (first == 0 || end + 1 >= y.size())
      return false;
    const double beside = std::max(step(first - 1), step(end)), least = std::min(step(first), step(end - 1));
    return std::isfinite(beside + step(first) + step(end - 1)) && least > factor * beside &&
           beside > 1e-9 * least; // rounding beside a step tells nothing
  };
  return jumps_over(i, 1) || jumps_over(i, 2) || (i > 0 && jumps_over(i - 1, 2));
}

Json numbers_or_null(const Values &values)
{
  Json list = Json::array();
  for (const double value : values)
    list.push_back(shortened(value, 9));
  return list;
}

std::vector<GridCurve> curves_of(const CaseList &list, const GridView &view, const Values &values)
{
  if (!view.has_two)
    return { { "", values } };
  const VariedEntry &other = list.entries[1 - view.along];
  const std::size_t n_along = list.entries[view.along].values.size(), n_curves = other.values.size();
  std::vector<GridCurve> curves;
  for (std::size_t c = 0; c < n_curves; ++c)
  {
    const auto number = parse_number(other.values[c]);
    curves.push_back(
      { number ? fmt::format(FMT_STRING("{:.3g}"), *number) : shortened(other.values[c], 30), {} });
    for (std::size_t i = 0; i < n_along; ++i)
      curves.back().values.push_back(values[view.along == 0 ? i * n_curves + c : c * n_along + i]);
  }
  return curves;
}

/// Heading of a picture, its axes, and how many cases it shows.
Json picture_of(const Drawing &drawing, const char *kind)
{
  const auto n = std::count_if(drawing.values.begin(), drawing.values.end(),
                               [](double value) { return std::isfinite(value); });
  return { { "id", drawing.key },
           { "kind", kind },
           { "caption", drawing.caption },
           { "label", drawing.label },
           { "cases", n } };
}

Json curves_picture(const VariedEntry &axis, const std::vector<GridCurve> &curves, const Drawing &drawing)
{
  const Values x = numbers_of(axis);
  Json picture = picture_of(drawing, "curves");
  picture.update({ { "x_label", label_of(axis) }, { "by_factors", axis.by_factors } });
  for (const GridCurve &curve : curves)
  {
    Values places, values;
    for (std::size_t i = 0; i < x.size(); ++i)
    {
      places.push_back(x[i]);
      values.push_back(curve.values[i]);
      if (jumps(curve.values, i))
      {
        places.push_back((x[i] + x[i + 1]) / 2);
        values.push_back(std::nan(""));
      }
    }
    picture["curves"].push_back(
      { { "name", curve.title }, { "x", numbers_or_null(places) }, { "y", numbers_or_null(values) } });
  }
  return picture;
}

Json map_picture(const std::vector<VariedEntry> &entries, const Drawing &drawing)
{
  const Values x = numbers_of(entries[0]), y = numbers_of(entries[1]);
  Json picture = picture_of(drawing, "map");
  picture.update({ { "x_label", label_of(entries[0]) },
                   { "y_label", label_of(entries[1]) },
                   { "x", numbers_or_null(x) },
                   { "y", numbers_or_null(y) },
                   { "x_by_factors", entries[0].by_factors },
                   { "y_by_factors", entries[1].by_factors } });
  for (std::size_t j = 0; j < y.size(); ++j)
  {
    Values row;
    for (std::size_t i = 0; i < x.size(); ++i)
      row.push_back(drawing.values[i * y.size() + j]);
    picture["values"].push_back(numbers_or_null(row));
  }
  return picture;
}

} // namespace

void add_sweep_pictures(const CaseList &list, const FinishedCases &finished, Document &document)
{
  Json &pictures = document.tables["pictures"] = Json::array();
  document.words["falls_over"] =
    std::any_of(finished.begin(), finished.end(), [](const auto &one) { return one.second.falls_over(); });
  if (!list.is_grid())
    return;
  const GridView view(list);
  if (!view.can_be_drawn)
    return;
  const auto values = [&](const std::string &key) { return values_of(list, finished, key); };
  const std::string legend = view.has_two ? ", by " + label_of(list.entries[1 - view.along]) : "";
  for (Drawing drawing :
       { Drawing{ "omega_terminal", "Terminal spin" + legend, values("omega_terminal") },
         Drawing{ "harmonic_effect",
                  "Effect of the higher harmonics of the load on the terminal spin" + legend,
                  values("harmonic_effect") },
         Drawing{ "contact_fraction", "Share of the land's area under pressure at rest" + legend,
                  values("contact_fraction") },
         Drawing{ "tau_at_rest", "Torque of friction at rest" + legend, values("tau_at_rest") } })
  {
    double min = std::nan(""), max = std::nan("");
    for (const double value : drawing.values)
    {
      min = std::fmin(min, value);
      max = std::fmax(max, value);
    }
    if (!(max - min > 1e-9 * std::max(std::abs(min), std::abs(max)))) // the same everywhere
      continue;
    if (view.is_map)
      pictures.push_back(map_picture(list.entries, drawing));
    else if (view.has_two || drawing.key != "omega_terminal")
      pictures.push_back(
        curves_picture(list.entries[view.along], curves_of(list, view, drawing.values), drawing));
    else
    {
      drawing.caption +=
        ", of all harmonics of the load, the first harmonic only, and a first harmonic on a ring of "
        "the contact radius. No line is drawn over a jump.";
      pictures.push_back(curves_picture(list.entries.front(),
                                        { { "all harmonics", drawing.values },
                                          { "first harmonic only", values("omega_first_harmonic") },
                                          { "first harmonic on a ring", values("omega_on_ring") } },
                                        drawing));
    }
  }
}

} // namespace stemware::pipeline
