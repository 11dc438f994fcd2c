#include "fem/pipeline/document/budget_rows.h"
#include "fem/pipeline/report/plots/plots.h"

namespace stemware::pipeline
{

namespace
{

using Json = nlohmann::ordered_json;

/// Steps of the model, then what is left out, one at a time.
Json effect_rows(const std::vector<BudgetRow> &steps, const std::vector<WithoutRow> &without)
{
  Json rows = Json::array();
  for (std::size_t i = 1; i < steps.size(); ++i)
    rows.push_back({ { "row", steps[i].name },
                     { "difference", steps[i].difference },
                     { "is_step", true },
                     { "is_defined", true } });
  for (const WithoutRow &row : without)
    rows.push_back({ { "row", "without " + row.name },
                     { "difference", row.difference },
                     { "is_step", false },
                     { "is_defined", row.reason != "not defined" } });
  return rows;
}

/// The steps between the paper's model and this study's, which have no difference.
Json waterfall_rows(std::vector<BudgetRow> steps)
{
  if (!steps.empty())
  {
    steps.push_back(steps.back());
    steps.back().name = "this study";
    steps.back().standing = Standing::no_balance; // whose row says whether it is formal
    steps.front().name = "the paper's model";
    steps.front().difference = steps.back().difference = std::nullopt;
  }
  Json rows = Json::array();
  for (const BudgetRow &row : steps)
  {
    const bool is_formal = row.standing == Standing::formal;
    rows.push_back({ { "row", row.name + (is_formal ? " (formal)" : "") },
                     { "omega_terminal", row.omega_terminal },
                     { "difference", row.difference },
                     { "band", row.band },
                     { "formal", is_formal } });
  }
  return rows;
}

} // namespace

void add_budget_plots(const Budget &budget, double rounding, Document &document)
{
  const std::vector<BudgetRow> steps = named_steps(budget.rows);
  document.facts["effects"] = effect_rows(steps, budget.without);
  document.facts["waterfall"] = waterfall_rows(steps);
  document.tables["harmonic_torque"] = { "Torque of friction against the spin",
                                         { numbers("omega", "rad/s", budget.omega),
                                           numbers("tau_z, all harmonics", "N m", budget.torque_all),
                                           numbers("tau_z, first harmonic", "N m", budget.torque_first) } };
  document.plots["waterfall"] = { { "rounding", rounding } };
  const double band = budget.rows.empty() ? 0 : budget.rows.back().band.value_or(0);
  document.plots["effects"] = { { "rounding", rounding }, { "band", band } };
}

} // namespace stemware::pipeline
