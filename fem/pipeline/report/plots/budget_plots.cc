#include "fem/pipeline/report/budget_tables.h"
#include "fem/pipeline/report/plots/plots.h"
#include "fem/pipeline/report/render/table_renderers.h"

#include <boost/algorithm/string/replace.hpp>

#include <cmath>

namespace stemware::pipeline
{

namespace
{

/// Text beside a row, with a true minus: a total or, with its sign, a difference.
std::string value_text(const std::optional<double> &value, bool is_total, double rounding)
{
  if (!value)
    return format::missing;
  if (std::abs(*value) < rounding)
    return "0";
  return boost::replace_all_copy(
    is_total ? format::significant<6>(*value) : format::signed_significant<3>(*value), "-", "−");
}

} // namespace

Plot waterfall_plot(const Budget &budget, double rounding)
{
  const double nothing = std::nan("");
  std::vector<BudgetRow> steps;
  if (!budget.rows.empty())
  {
    steps = named_steps(budget.rows);
    steps.front().name = "the paper's model";
    steps.push_back(budget.rows.back());
    steps.back().name = "this study";
    steps.back().standing = Standing::no_balance; // whose row says whether it is formal
  }
  std::vector<std::string> names, texts;
  std::vector<std::vector<double>> rows;
  for (std::size_t i = 0; i < steps.size(); ++i)
  {
    const BudgetRow &row = steps[i];
    const bool is_last = i + 1 == steps.size(), is_total = i == 0 || is_last;
    const bool is_formal = row.standing == Standing::formal;
    const std::optional<double> difference = is_total ? std::nullopt : row.difference;
    const double after = row.omega_terminal.value_or(nothing), before = after - difference.value_or(nothing);
    names.push_back(row.name + (is_formal ? " (formal)" : ""));
    texts.push_back(value_text(is_total ? row.omega_terminal : difference, is_total, rounding));
    rows.push_back({ static_cast<double>(steps.size() - i), before, after, row.band.value_or(0),
                     difference ? (std::abs(after) > std::abs(before) ? 1. : 2.) + (is_formal ? 2 : 0) : 0,
                     !is_last && row.omega_terminal && steps[i + 1].omega_terminal ? -1. : 0. });
  }
  return plot_from("waterfall", { { "row", names }, { "row_text", texts } },
                   data_table(number_rows("From the paper's model to this study's",
                                          { { "place from below", "1" },
                                            { "omega before", "rad/s" },
                                            { "omega", "rad/s" },
                                            { "half-width of its error band, 0: none", "rad/s" },
                                            { "1: faster, 2: slower, 3, 4: the same, formally", "1" },
                                            { "line to the next row", "1" } },
                                          rows)));
}

Plot effects_plot(const Budget &budget, double rounding)
{
  const std::vector<BudgetRow> steps = named_steps(budget.rows);
  const std::size_t n_rows = steps.size() - 1 + budget.without.size();
  std::vector<std::string> names, texts;
  std::vector<std::vector<double>> rows;
  const auto add = [&](const std::string &name, const std::optional<double> &difference, bool is_step)
  {
    const double size = std::abs(difference.value_or(0));
    names.push_back(name);
    texts.push_back(value_text(difference, false, rounding));
    rows.push_back({ static_cast<double>(n_rows - rows.size()),
                     difference && size >= rounding ? size : std::nan(""), is_step ? 1. : 0. });
  };
  for (std::size_t i = 1; i < steps.size(); ++i)
    add(steps[i].name, steps[i].difference, true);
  for (const WithoutRow &row : budget.without)
  {
    add("without " + row.name, row.difference, false);
    if (!row.difference && row.reason == "not defined")
      texts.back() = row.reason;
  }
  return plot_from(
    "effects", { { "row", names }, { "row_text", texts }, { "band", budget.rows.back().band.value_or(0) } },
    data_table(number_rows("Differences of terminal spins",
                           { { "place from below", "1" },
                             { "size of the difference", "rad/s" },
                             { "1: a step of the model, 0: one thing left out", "1" } },
                           rows)));
}

Plot harmonic_torque_plot(const Budget &budget)
{
  return plot_from("harmonic_torque", {},
                   data_table({ "Torque of friction against the spin",
                                { numbers("omega", "rad/s", budget.omega),
                                  numbers("tau_z, all harmonics", "N m", budget.torque_all),
                                  numbers("tau_z, first harmonic", "N m", budget.torque_first) } }));
}

Plot one_way(Plot plot)
{
  if (!plot.drawing.empty())
    return plot;
  plot.caption += std::string(plot.caption.empty() || plot.caption.back() == '.' ? "" : ".") +
                  " One-way: the load of rest is kept at every spin.";
  plot.script = "note = \"one-way: load of rest kept\"\n" + plot.script;
  return plot;
}

} // namespace stemware::pipeline
