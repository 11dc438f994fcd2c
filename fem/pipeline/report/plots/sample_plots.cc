#include "fem/pipeline/report/plots/plots.h"
#include "fem/pipeline/report/render/table_renderers.h"
#include "fem/pipeline/support/numbers.h"

#include <algorithm>
#include <cmath>

namespace stemware::pipeline
{

namespace
{

std::string label_of(const QuantityFindings &about)
{
  return with_unit(about.quantity().name, about.quantity().unit);
}

/// The entry that the linear fit depends on most.
std::size_t strongest_entry(const QuantityFindings &about)
{
  std::vector<double> weights;
  for (const double coefficient : about.sensitivity->regression)
    weights.push_back(std::abs(coefficient));
  return static_cast<std::size_t>(std::max_element(weights.begin(), weights.end()) - weights.begin());
}

/// Values of the cases that have one, over that of the strongest entry.
Plot samples_plot(const SweepPlan &plan, const FinishedCases &cases, const std::string &name,
                  const QuantityFindings &about)
{
  const std::size_t entry = strongest_entry(about);
  const SweptEntry &along = plan.entries[entry];
  std::vector<std::vector<double>> rows;
  for (const auto &[index, result] : cases)
    if (result.is_solved() && result.values[about.index])
      rows.push_back({ parse_number(plan.cases[index][entry]).value(), *result.values[about.index] });
  return plot_from(
           "curves",
           { { "x_label", label_of(along) },
             { "y_label", label_of(about) },
             { "is_logarithmic", along.by_factors },
             { "style", "points" },
             { "curve", std::vector<std::string>{ "" } },
             { "n_points", 0. } },
           data_table(number_rows(
             "Samples", { { name_of(along), along.unit }, { about.quantity().name, about.quantity().unit } },
             rows)))
    .as(name + "_samples",
        "All samples over the parameter that the linear fit depends on most: " + about.quantity().name);
}

/// How many of the samples of samples_plot() lie in each of equal intervals.
Plot histogram(const std::string &name, const QuantityFindings &about)
{
  Plot plot = plot_from("histogram", { { "x_label", label_of(about) } });
  plot.data_file = "figures/" + name + "_samples.dat";
  return plot.as(name + "_histogram", "Distribution of the samples: " + about.quantity().name);
}

/// Changes of a quantity by one standard deviation of each entry, in the linear fit, the largest on top.
Plot tornado(const SweepPlan &plan, const std::string &name, const QuantityFindings &about)
{
  std::vector<std::pair<double, std::string>> bars;
  for (std::size_t i = 0; i < plan.entries.size(); ++i)
    bars.emplace_back(about.sensitivity->regression[i] * about.band->deviation, name_of(plan.entries[i]));
  std::stable_sort(bars.begin(), bars.end(),
                   [](const auto &a, const auto &b) { return std::abs(a.first) < std::abs(b.first); });
  std::vector<std::string> names;
  std::vector<std::vector<double>> rows;
  for (const auto &[change, entry] : bars)
  {
    names.push_back(entry);
    rows.push_back({ static_cast<double>(names.size()), -change, change });
  }
  return plot_from("tornado", { { "row", names }, { "x_label", "change of " + label_of(about) } },
                   data_table(number_rows("Change of the " + about.quantity().name,
                                          { { "place from below", "1" },
                                            { "change when it goes down", about.quantity().unit },
                                            { "change when it goes up", about.quantity().unit } },
                                          rows)))
    .as(name + "_tornado",
        "Change of the " + about.quantity().name +
          " by one standard deviation of each parameter, from a linear fit of the samples");
}

} // namespace

std::vector<Plot> sample_plots(const SweepPlan &plan, const FinishedCases &cases,
                               const SweepFindings &findings)
{
  std::vector<Plot> plots;
  for (const auto &[name, quantity] :
       { std::pair("terminal_spin", "terminal spin"), std::pair("harmonic_effect", "harmonic effect") })
  {
    const QuantityFindings *about = findings.about(quantity);
    if (about == nullptr || !about->sensitivity) // nothing varies
      continue;
    plots.push_back(histogram(name, *about));
    plots.push_back(tornado(plan, name, *about));
    plots.push_back(samples_plot(plan, cases, name, *about));
  }
  return plots;
}

} // namespace stemware::pipeline
