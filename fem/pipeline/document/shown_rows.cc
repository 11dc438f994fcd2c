#include "fem/pipeline/document/shown_rows.h"

#include "fem/pipeline/document/table.h"

#include <algorithm>
#include <cmath>

namespace stemware::pipeline
{

using Json = nlohmann::ordered_json;

Json shown_chain(const Study &study, std::vector<BudgetRow> rows)
{
  const double band = rows.empty() ? 0 : rows.back().band.value_or(0);
  const double torque_at_rest = rows.empty() ? 0 : rows.back().torques[0].value_or(0);
  const auto changes_nothing = [&](const BudgetRow &row)
  {
    return row.name == "harmonics" && row.harmonics && row.difference &&
           std::abs(*row.difference) < std::max(band, rounding_of_spins(study));
  };
  // A difference is that to the row above among the shown rows.
  std::vector<BudgetRow> kept;
  for (BudgetRow &row : rows)
  {
    if (changes_nothing(row))
      continue;
    if (row.omega_terminal && !kept.empty() && kept.back().omega_terminal)
      row.difference = *row.omega_terminal - *kept.back().omega_terminal + 0.; // no -0
    else
      row.difference = std::nullopt;
    kept.push_back(row);
  }
  Json shown = chain_rows(study, kept);
  zero_rounding_errors(shown, "omega_terminal difference", rounding_of_spins(study));
  zero_rounding_errors(shown, "relative_difference", 1e-9);
  zero_rounding_errors(shown, "torques", 1e-9 * std::abs(torque_at_rest));
  for (Json &row : shown)
    if (Json &omega = row["omega_terminal"]; band > 0 && omega.is_number() && omega != 0.)
      omega = format::rounded_to_error(omega, band);
  return shown;
}

Json budget_summary(const Study &study, const std::vector<BudgetRow> &rows)
{
  Json summary = declared(chain_rows(study, rows), "budget");
  if (std::none_of(rows.begin(), rows.end(), [](const BudgetRow &row) { return row.torques[0].has_value(); }))
    for (Json &row : summary)
      row.erase("torques");
  return summary;
}

} // namespace stemware::pipeline
