#include "fem/pipeline/report/budget_tables.h"
#include "fem/pipeline/report/plots/plots.h"
#include "fem/pipeline/report/quantities.h"

namespace stemware::pipeline
{

namespace
{

/// A row of the plot of effects.
struct Effect
{
  std::string name;
  std::optional<double> difference;
  bool is_step = false; ///< of the model, and no thing that is left out
  bool is_defined = true;
};

} // namespace

void add_budget_plots(const Budget &budget, double rounding, Document &document)
{
  std::vector<BudgetRow> steps = named_steps(budget.rows);
  std::vector<Effect> effects;
  for (std::size_t i = 1; i < steps.size(); ++i)
    effects.push_back({ steps[i].name, steps[i].difference, true });
  for (const WithoutRow &row : budget.without)
    effects.push_back({ "without " + row.name, row.difference, false, row.reason != "not defined" });
  document.tables["effects"] = { "Differences of terminal spins",
                                 { column(Quantity("row", "", ""), effects, &Effect::name),
                                   column(quantity::spin_difference, effects, &Effect::difference),
                                   column(Quantity("", "1: a step of the model"), effects, &Effect::is_step),
                                   column(Quantity("", "0: not defined"), effects, &Effect::is_defined) } };

  if (!steps.empty())
  {
    steps.push_back(budget.rows.back());
    steps.back().name = "this study";
    steps.back().standing = Standing::no_balance; // whose row says whether it is formal
    steps.front().name = "the paper's model";
    steps.front().difference = steps.back().difference = std::nullopt;
  }
  const auto is_formal = [](const BudgetRow &row) { return row.standing == Standing::formal; };
  document.tables["waterfall"] = {
    "From the paper's model to this study's",
    { column(Quantity("row", "", ""), steps,
             [&](const BudgetRow &row) { return row.name + (is_formal(row) ? " (formal)" : ""); }),
      column(quantity::omega_terminal, steps, &BudgetRow::omega_terminal),
      column(quantity::spin_difference, steps, &BudgetRow::difference),
      column(quantity::spin_band, steps, &BudgetRow::band), column(quantity::formal_flag, steps, is_formal) }
  };
  document.tables["harmonic_torque"] = { "Torque of friction against the spin",
                                         { column(quantity::omega, budget.omega),
                                           column(quantity::tau_z, budget.torque_all),
                                           numbers("tau_z, first harmonic", "N m", budget.torque_first) } };
  document.plots["waterfall"] = { { "rounding", rounding } };
  const double band = budget.rows.empty() ? 0 : budget.rows.back().band.value_or(0);
  document.plots["effects"] = { { "rounding", rounding }, { "band", band } };
}

} // namespace stemware::pipeline
