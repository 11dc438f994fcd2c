#include "fem/pipeline/pictures/spin_rows.h"

#include <algorithm>
#include <cmath>

namespace stemware::pipeline
{

using Json = nlohmann::ordered_json;

namespace
{

double friction_torque(const ring::RingState &state)
{
  return state.friction.torque;
}

Json force_of(const ring::RingState &state)
{
  return { state.friction.force_x, state.friction.force_y };
}

/// The effect of harmonics on the torque, by the keys of a row of "truncation" and of its tables.
Json effect_numbers(const ring::TorqueEffect &effect, double torque_at_rest)
{
  using AtSpin = ring::TorqueEffect::AtSpin;
  const auto relative = [&](const Json &torque)
  {
    return torque.is_null() || torque_at_rest == 0 ? Json(nullptr)
                                                   : Json(torque.get<double>() / torque_at_rest);
  };
  Json change = { { "half", to_json_or_null(effect.half, &AtSpin::change) },
                  { "terminal", to_json_or_null(effect.terminal, &AtSpin::change) },
                  { "largest", effect.largest },
                  { "largest_at", effect.largest_at } };
  Json numbers = { { "torque_rest",
                     { { "half", to_json_or_null(effect.half, &AtSpin::rest) },
                       { "terminal", to_json_or_null(effect.terminal, &AtSpin::rest) } } },
                   { "bound_half", to_json_or_null(effect.half, &AtSpin::bound) },
                   { "bound", to_json_or_null(effect.terminal, &AtSpin::bound) },
                   { "rest_half", to_json_or_null(effect.half, &AtSpin::rest) },
                   { "rest_terminal", to_json_or_null(effect.terminal, &AtSpin::rest) },
                   { "change_largest_at", effect.largest_at } };
  for (const char *state : { "half", "terminal", "largest" })
  {
    numbers[std::string("change_") + state] = change[state];
    numbers[std::string("change_") + state + "_relative"] = change[std::string(state) + "_relative"] =
      relative(change[state]);
  }
  numbers["torque_change"] = change;
  return numbers;
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
                     { "tau_at_rest", to_json_or_null(rest, friction_torque) },
                     { "lean_torque_at_rest", to_json_or_null(rest, &ring::RingState::lean_torque) },
                     { "omega_terminal", row.omega_terminal() },
                     { "omega_terminal_band", row.band },
                     { "tau_at_terminal", to_json_or_null(end, friction_torque) },
                     { "lean_torque_at_terminal", to_json_or_null(end, &ring::RingState::lean_torque) },
                     { "grip_torque_at_terminal", to_json_or_null(end, &ring::RingState::grip_torque) },
                     { "force_at_terminal", to_json_or_null(end, force_of) },
                     { "time_constant", row.time_constant() },
                     { "relative_change", row.relative_change },
                     { "load_minimum", to_json_or_null(rest, &ring::RingState::minimum) },
                     { "pulling_share", to_json_or_null(rest, &ring::RingState::pulling_share) },
                     { "moment_ratio_at_terminal", to_json_or_null(end, &ring::RingState::moment_ratio) },
                     { "message", text_or_null(row.reason) } });
  }
  return list;
}

Json truncation_rows(const std::vector<ring::Answer> &rows, const ring::TorqueEffects &effects, double scale)
{
  Json list = Json::array();
  for (const ring::TorqueEffect &effect : effects.rows)
  {
    ring::Answer not_solved;
    not_solved.harmonics = effect.harmonics;
    const auto row =
      std::find_if(rows.begin(), rows.end(),
                   [&](const ring::Answer &answer) { return answer.harmonics == effect.harmonics; });
    const ring::Answer &answer = row == rows.end() ? not_solved : *row;
    list.push_back(spin_rows({ answer })[0]);
    list.back().update(effect_numbers(effect, effects.torque_at_rest));
    list.back()["spin_change"] =
      harmonic_effect(rows.front().omega_terminal(), answer.omega_terminal(), scale).relative;
  }
  return list;
}

Json torque_effect_summary(const ring::TorqueEffects &effects)
{
  if (effects.rows.size() < 2)
    return nullptr;
  return effect_numbers(effects.rows.back(), effects.torque_at_rest)["torque_change"];
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
  return row.harmonics ? "harmonics, n " + at_most + ' ' + std::to_string(*row.harmonics) : "harmonics, all";
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

Json harmonic_effect_summary(const HarmonicEffect &effect)
{
  return { { "absolute", effect.absolute }, { "relative", effect.relative } };
}

bool is_spin(const Study &study, double omega)
{
  return std::abs(omega) >= rounding_of_spins(study);
}

} // namespace stemware::pipeline
