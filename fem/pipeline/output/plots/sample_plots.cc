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

/// A quantity to be drawn.
struct SampledQuantity
{
  std::string name; ///< beginning of the plots' names
  std::string label;
  std::string quantity;
};

const std::vector<SampledQuantity> sampled_quantities = {
  { "terminal_spin", "terminal spin (rad/s)", "terminal spin" },
  { "harmonic_effect", "harmonic effect (%)", "harmonic effect" }
};

/// Values of the cases that have one, with the value of an entry.
std::pair<std::vector<double>, std::vector<double>>
pairs_of(const SweepPlan &plan, const FinishedCases &cases, std::size_t entry, std::size_t quantity)
{
  std::pair<std::vector<double>, std::vector<double>> pairs;
  for (const auto &[index, result] : cases)
    if (result.is_solved() && result.values[quantity])
    {
      pairs.first.push_back(parse_number(plan.cases[index][entry]).value());
      pairs.second.push_back(*result.values[quantity]);
    }
  return pairs;
}

/// How many values lie in each of equal intervals, about the square root of their number.
Plot histogram(const SampledQuantity &drawing, const std::vector<double> &values)
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
  const std::string name = drawing.name + "_histogram",
                    caption = "Distribution of the samples: " + drawing.quantity;
  const std::string script = "set xlabel \"" + drawing.label + "\"\n" + tic_commands("x", *least, *most) +
                             "set xrange [" + to_text(*least - width) + ":" + to_text(*most + width) + "]\n" +
                             "set ylabel \"samples\"\nset yrange [0:*]\nset boxwidth " + to_text(width) +
                             "\nset style fill solid 0.6\nplot \"figures/" + name +
                             ".dat\" using 1:2 with boxes lt 1 notitle\n";
  return { name,
           caption,
           script,
           540,
           360,
           data_table({ caption,
                        { numbers("middle of the interval: " + drawing.label, "", middles),
                          numbers("samples", "1", counts) } }) };
}

/// Changes of a quantity by one standard deviation of each entry, in the linear fit.
Plot tornado(const SweepPlan &plan, const SampledQuantity &drawing, const QuantityFindings &about)
{
  std::vector<Sensitivity> bars;
  for (std::size_t i = 0; i < plan.entries.size(); ++i)
  {
    const double change = about.sensitivity->regression[i] * about.band->deviation;
    bars.push_back({ plan.entries[i].path.substr(plan.entries[i].path.find('/') + 1), -change, change });
  }
  return tornado_plot(drawing.name + "_tornado",
                      "Change of the " + drawing.quantity +
                        " by one standard deviation of each parameter, from a linear fit of the samples",
                      "change: " + drawing.label, bars);
}

Plot scatter(const SweepPlan &plan, const FinishedCases &cases, const SampledQuantity &drawing,
             const QuantityFindings &about)
{
  const std::vector<double> &shares = about.sensitivity->first_order;
  const auto entry =
    static_cast<std::size_t>(std::max_element(shares.begin(), shares.end()) - shares.begin());
  const SweptEntry &swept = plan.entries[entry];
  const auto [x, y] = pairs_of(plan, cases, entry, about.index);
  CurvePlot plot = { drawing.name + "_samples",
                     "All samples over the parameter with the largest first-order share: " + drawing.quantity,
                     { with_unit(swept.path.substr(swept.path.find('/') + 1), swept.unit, false),
                       swept.by_factors },
                     { drawing.label },
                     {} };
  Curve curve;
  curve.x = x;
  curve.y = y;
  curve.style = CurveStyle::points;
  plot.curves = { curve };
  return curve_plot(plot);
}

} // namespace

std::vector<Plot> sample_plots(const SweepPlan &plan, const FinishedCases &cases,
                               const SweepFindings &findings)
{
  std::vector<Plot> plots;
  for (const SampledQuantity &drawing : sampled_quantities)
  {
    const QuantityFindings *about = findings.about(drawing.quantity);
    if (about == nullptr || !about->sensitivity) // nothing varies
      continue;
    plots.push_back(histogram(drawing, pairs_of(plan, cases, 0, about->index).second));
    plots.push_back(tornado(plan, drawing, *about));
    plots.push_back(scatter(plan, cases, drawing, *about));
  }
  return plots;
}

} // namespace stemware::pipeline
