#include "fem/pipeline/report/budget_tables.h"

#include "fem/pipeline/report/quantities.h"
#include "fem/pipeline/report/render/table_renderers.h"

#include <algorithm>
#include <cmath>

namespace stemware::pipeline
{

namespace
{

using Json = nlohmann::ordered_json;

/// A spin that nothing is related to [rad/s].
double rounding_of_spins(const Study &study)
{
  return 1e-9 * spin_scale(study);
}

/// "formal", or why something is missing; empty for what stands as it is.
std::string state_of(const BudgetRow &row)
{
  if (!row.reason.empty())
    return row.reason;
  return row.omega_terminal && row.standing != Standing::formal ? "" : to_string(row.standing);
}

std::optional<std::string> reason_or_nothing(const std::string &reason)
{
  return reason.empty() ? std::nullopt : std::optional(reason);
}

} // namespace

std::string label_of(const ChainStep &step)
{
  return std::to_string(step.number) + (step.is_addition ? "a" : "");
}

std::string title_of(const BudgetRow &row, const std::string &at_most)
{
  if (row.name == "paper")
    return "the paper's model";
  if (row.name != "harmonics")
    return row.name;
  return row.harmonics ? fmt::format(FMT_STRING("harmonics, n {} {}"), at_most, *row.harmonics)
                       : "harmonics, all";
}

Table budget_table(const Study &study, const Budget &budget)
{
  using Row = BudgetRow;
  const std::vector<Row> &rows = budget.rows;
  const double small_spin = rounding_of_spins(study);
  const auto harmonics = [](const Row &row) { return row.harmonics ? Json(*row.harmonics) : Json("all"); };
  const auto relative = [&](const Row &row)
  {
    const auto above = row.difference ? std::optional(*row.omega_terminal - *row.difference) : std::nullopt;
    return relative_to(above, row.difference, spin_scale(study));
  };
  const double torque_at_rest = rows.empty() ? 0 : rows.back().torques[0].value_or(0);
  Table table = {
    "",
    { column(quantity::step_of_budget, rows, [](const Row &row) { return label_of(row.step); }),
      column(quantity::effect_name, rows, &Row::name),
      column(quantity::effect, rows, [](const Row &row) { return title_of(row); }),
      column(
        quantity::effect.with(&Quantity::key, "console_title").with(&Quantity::label, "model, row by row"),
        rows, [](const Row &row) { return title_of(row, "<="); }),
      column(quantity::harmonics, rows, harmonics),
      column(quantity::harmonics.with(&Quantity::key, "harmonics_kept")
               .with(&Quantity::name, "harmonics kept, nan: all"),
             rows, &Row::harmonics),
      column(quantity::omega_terminal, rows, &Row::omega_terminal, small_spin),
      column(quantity::spin_difference, rows, &Row::difference, small_spin),
      column(quantity::relative_difference, rows, relative, 1e-9),
      column(quantity::spin_band, rows, &Row::band), column(quantity::budget_state, rows, state_of),
      column(quantity::state, rows, [](const Row &row) { return to_string(row.standing); }),
      column(quantity::formal_flag, rows, [](const Row &row) { return row.standing == Standing::formal; }),
      column(quantity::reason, rows, [](const Row &row) { return reason_or_nothing(row.reason); }) }
  };
  const char *places[] = { "rest", "half the terminal spin", "the terminal spin" };
  for (std::size_t i = 0; i < 3; ++i)
    table.columns.push_back(column(
      quantity::torque_of_budget(places[i]), rows, [=](const Row &row) { return row.torques[i]; },
      1e-9 * std::abs(torque_at_rest)));
  return table;
}

Table shown_budget_table(const Study &study, const Budget &budget)
{
  Budget shown = budget;
  const double band = budget.rows.empty() ? 0 : budget.rows.back().band.value_or(0);
  const auto changes_nothing = [&](const BudgetRow &row)
  {
    return row.name == "harmonics" && row.harmonics && row.difference &&
           std::abs(*row.difference) < std::max(band, rounding_of_spins(study));
  };
  shown.rows.erase(std::remove_if(shown.rows.begin(), shown.rows.end(), changes_nothing), shown.rows.end());
  Table table = budget_table(study, shown);
  for (Column &column : table.columns)
    if (column.quantity.key == quantity::omega_terminal.key)
      column.uncertainty = band;
  return table;
}

std::vector<BudgetRow> named_steps(const std::vector<BudgetRow> &rows)
{
  std::vector<BudgetRow> steps;
  std::optional<double> first; // terminal spin of the first harmonic alone
  for (const BudgetRow &row : rows)
  {
    if (row.name != "harmonics" || steps.empty() || steps.back().name != "harmonics")
    {
      first = row.difference ? std::optional(*row.omega_terminal - *row.difference) : std::nullopt;
      steps.push_back(row);
      continue;
    }
    steps.back() = row;
    steps.back().difference =
      first && row.omega_terminal ? std::optional(*row.omega_terminal - *first) : std::nullopt;
  }
  return steps;
}

Table without_table(const Study &study, const Budget &budget)
{
  using Row = WithoutRow;
  const std::vector<Row> &rows = budget.without;
  const std::optional<double> complete =
    budget.rows.empty() ? std::nullopt : budget.rows.back().omega_terminal;
  return { "",
           { column(quantity::left_out, rows, &Row::name),
             column(quantity::omega_terminal, rows, &Row::omega_terminal),
             column(quantity::spin_difference, rows, &Row::difference, rounding_of_spins(study)),
             column(
               quantity::relative_difference, rows,
               [&](const Row &row) { return relative_to(complete, row.difference, spin_scale(study)); },
               1e-9),
             column(quantity::budget_state, rows, &Row::reason),
             column(quantity::reason, rows, [](const Row &row) { return reason_or_nothing(row.reason); }) } };
}

Budget chain_alone(std::vector<BudgetRow> rows)
{
  Budget budget;
  budget.rows = std::move(rows);
  return budget;
}

Json budget_summary(const Study &study, const Budget &budget)
{
  const bool has_torques = std::any_of(budget.rows.begin(), budget.rows.end(),
                                       [](const BudgetRow &row) { return row.torques[0].has_value(); });
  return json_table(budget_table(study, budget)
                      .with("", std::string("step name harmonics omega_terminal difference band ") +
                                  (has_torques ? "torques[] " : "") + "state reason"));
}

Json without_summary(const Study &study, const Budget &budget)
{
  return json_table(without_table(study, budget).with("", "name omega_terminal difference reason"));
}

Json harmonic_effect_summary(const HarmonicEffect &effect)
{
  return { { "absolute", json_number(effect.absolute) }, { "relative", json_number(effect.relative) } };
}

bool is_spin(const Study &study, double omega)
{
  return std::abs(omega) >= rounding_of_spins(study);
}

} // namespace stemware::pipeline
