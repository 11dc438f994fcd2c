#include "fem/pipeline/document/spin_rows.h"

#include "fem/pipeline/document/table.h"

#include <algorithm>
#include <cmath>

namespace stemware::pipeline
{

using Json = nlohmann::ordered_json;

namespace
{

double torque_of(const ring::RingState &state)
{
  return state.friction.torque;
}

Json force_of(const ring::RingState &state)
{
  return { state.friction.force_x, state.friction.force_y };
}

/// "formal", or why something is missing; empty for what stands as it is.
std::string state_of(const BudgetRow &row)
{
  if (!row.reason.empty())
    return row.reason;
  return row.omega_terminal && row.status != ring::Status::formal ? "" : to_string(row.status);
}

} // namespace

Json spin_rows(const std::vector<ring::Answer> &rows)
{
  Json list = Json::array();
  for (const ring::Answer &row : rows)
  {
    const auto &rest = row.at_rest, &end = row.at_terminal;
    list.push_back({ { "harmonics", row.harmonics },
                     { "tau_at_rest", to_json_or_null(rest, torque_of) },
                     { "lean_torque_at_rest", to_json_or_null(rest, &ring::RingState::lean_torque) },
                     { "omega_terminal", row.omega_terminal() },
                     { "omega_terminal_band", row.band },
                     { "tau_at_terminal", to_json_or_null(end, torque_of) },
                     { "lean_torque_at_terminal", to_json_or_null(end, &ring::RingState::lean_torque) },
                     { "grip_torque_at_terminal", to_json_or_null(end, &ring::RingState::grip_torque) },
                     { "force_at_terminal", to_json_or_null(end, force_of) },
                     { "time_constant", row.time_constant() },
                     { "relative_change", row.relative_change },
                     { "bound", row.bound },
                     { "load_minimum", to_json_or_null(rest, &ring::RingState::minimum) },
                     { "pulling_share", to_json_or_null(rest, &ring::RingState::pulling_share) },
                     { "moment_ratio_at_terminal", to_json_or_null(end, &ring::RingState::moment_ratio) },
                     { "message", text_or_null(row.reason) } });
  }
  return list;
}

Json shown_spin_rows(const std::vector<ring::Answer> &rows)
{
  constexpr double small_change = 1e-11;
  Json shown = spin_rows(rows);
  const auto &rest = rows.back().at_rest;
  zero_rounding_errors(shown, "tau_at_rest", rest ? 1e-12 * std::abs(torque_of(*rest)) : 0);
  zero_rounding_errors(shown, "relative_change", small_change);
  return shown;
}

Json fall_summary(const ring::Answer &all)
{
  return to_json_or_null(all.fall,
                         [](const ring::Fall &fall) -> Json {
                           return { { "omega", fall.omega }, { "moment_ratio", fall.state.moment_ratio } };
                         });
}

Json series_summary(const ring::RingStack &load)
{
  Json a = Json::array(), b = Json::array();
  for (unsigned int n = 0; n <= load.n_harmonics(); ++n)
  {
    a.push_back(load.a(n));
    b.push_back(load.b(n));
  }
  return { { "a", a }, { "b", b } };
}

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

Json chain_rows(const Study &study, const std::vector<BudgetRow> &rows)
{
  Json list = Json::array();
  for (const BudgetRow &row : rows)
  {
    const auto above = row.difference ? std::optional(*row.omega_terminal - *row.difference) : std::nullopt;
    list.push_back({ { "step", label_of(row.step) },
                     { "name", row.name },
                     { "title", title_of(row) },
                     { "console_title", title_of(row, "<=") },
                     { "harmonics", row.harmonics ? Json(*row.harmonics) : Json("all") },
                     { "harmonics_kept", row.harmonics },
                     { "omega_terminal", row.omega_terminal },
                     { "difference", row.difference },
                     { "relative_difference", relative_to(above, row.difference, spin_scale(study)) },
                     { "band", row.band },
                     { "torques", row.torques },
                     { "remark", state_of(row) },
                     { "state", to_string(row.status) },
                     { "formal", row.status == ring::Status::formal },
                     { "reason", text_or_null(row.reason) } });
  }
  return list;
}

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

Json without_rows(const Study &study, const Budget &budget)
{
  const auto complete = budget.rows.empty() ? std::nullopt : budget.rows.back().omega_terminal;
  Json list = Json::array();
  for (const WithoutRow &row : budget.without)
    list.push_back({ { "name", row.name },
                     { "omega_terminal", row.omega_terminal },
                     { "difference", row.difference },
                     { "relative_difference", relative_to(complete, row.difference, spin_scale(study)) },
                     { "remark", row.reason },
                     { "reason", text_or_null(row.reason) } });
  return list;
}

Json budget_summary(const Study &study, const std::vector<BudgetRow> &rows)
{
  Json summary = declared(chain_rows(study, rows), "budget");
  if (std::none_of(rows.begin(), rows.end(), [](const BudgetRow &row) { return row.torques[0].has_value(); }))
    for (Json &row : summary)
      row.erase("torques");
  return summary;
}

Json harmonic_effect_summary(const HarmonicEffect &effect)
{
  return { { "absolute", effect.absolute }, { "relative", effect.relative } };
}

bool is_spin(const Study &study, double omega)
{
  return std::abs(omega) >= rounding_of_spins(study);
}

} // namespace stemware::pipeline
