#include "fem/pipeline/output/plots/plots.h"
#include "fem/pipeline/output/render/plot_script.h"
#include "fem/pipeline/output/render/table_renderers.h"
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

/// Values of the cases that have one, over the value of an entry.
Curve samples(const SweepPlan &plan, const FinishedCases &cases, std::size_t entry, std::size_t quantity)
{
  Curve curve = { "", {}, {}, CurveStyle::points };
  for (const auto &[index, result] : cases)
    if (result.is_solved() && result.values[quantity])
      curve.add(parse_number(plan.cases[index][entry]).value(), *result.values[quantity]);
  return curve;
}

/// How many values lie in each of equal intervals, about the square root of their number.
Plot histogram(const std::string &name, const QuantityFindings &about, const std::vector<double> &values)
{
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  const auto n_bins =
    static_cast<std::size_t>(std::clamp(std::ceil(std::sqrt(static_cast<double>(values.size()))), 5., 60.));
  const double width = (*most - *least) / static_cast<double>(n_bins);
  std::vector<double> middles, counts(n_bins, 0.);
  for (std::size_t i = 0; i < n_bins; ++i)
    middles.push_back(*least + (static_cast<double>(i) + 0.5) * width);
  for (const double value : values)
    ++counts[std::min(static_cast<std::size_t>((value - *least) / width), n_bins - 1)];
  const std::string caption = "Distribution of the samples: " + about.quantity().name;
  const std::string script = "set xlabel \"" + label_of(about) + "\"\n" + tic_commands("x", *least, *most) +
                             "set xrange [" + to_text(*least - width) + ":" + to_text(*most + width) + "]\n" +
                             "set ylabel \"samples\"\nset yrange [0:*]\nset boxwidth " + to_text(width) +
                             "\nset style fill solid 0.6\nplot data using 1:2 with boxes lt 1 notitle\n";
  return { name + "_histogram", caption, script,
           data_table({ caption,
                        { numbers("middle of the interval: " + label_of(about), "", middles),
                          numbers("samples", "1", counts) } }) };
}

/// Changes of a quantity by one standard deviation of each entry, in the linear fit.
Plot tornado(const SweepPlan &plan, const std::string &name, const QuantityFindings &about)
{
  std::vector<Sensitivity> bars;
  for (std::size_t i = 0; i < plan.entries.size(); ++i)
  {
    const double change = about.sensitivity->regression[i] * about.band->deviation;
    bars.push_back({ name_of(plan.entries[i]), -change, change });
  }
  return tornado_plot(name + "_tornado",
                      "Change of the " + about.quantity().name +
                        " by one standard deviation of each parameter, from a linear fit of the samples",
                      "change of " + label_of(about), bars);
}

Plot scatter(const SweepPlan &plan, const FinishedCases &cases, const std::string &name,
             const QuantityFindings &about)
{
  std::vector<double> weights;
  for (const double coefficient : about.sensitivity->regression)
    weights.push_back(std::abs(coefficient));
  const auto entry =
    static_cast<std::size_t>(std::max_element(weights.begin(), weights.end()) - weights.begin());
  return curve_plot(
    { name + "_samples",
      "All samples over the parameter that the linear fit depends on most: " + about.quantity().name,
      axis_of(plan.entries[entry]),
      { label_of(about) },
      { samples(plan, cases, entry, about.index) } });
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
    plots.push_back(histogram(name, *about, samples(plan, cases, 0, about->index).y));
    plots.push_back(tornado(plan, name, *about));
    plots.push_back(scatter(plan, cases, name, *about));
  }
  return plots;
}

} // namespace stemware::pipeline
