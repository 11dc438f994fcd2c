#include "fem/pipeline/document/spin_rows.h"

#include "fem/pipeline/document/table.h"

#include <cmath>
#include <functional>

namespace stemware::pipeline
{

using Json = nlohmann::ordered_json;

namespace
{

/// A number of a row's load in some state; null where there is no such load.
template <typename Value>
Json number_of(const std::optional<RingState> &state, Value value)
{
  return state ? Json(std::invoke(value, *state)) : Json(nullptr);
}

double torque_of(const RingState &state)
{
  return state.friction.torque;
}

Json force_of(const RingState &state)
{
  return { state.friction.force_x, state.friction.force_y };
}

Json load_of(const RingState &state)
{
  Json summary = series_summary(state.load);
  summary["ring_radius"] = state.load.radius();
  summary["moment_ratio"] = state.moment_ratio;
  return summary;
}

} // namespace

Json spin_rows(const std::vector<SpinRow> &rows)
{
  Json list = Json::array();
  for (const SpinRow &row : rows)
  {
    const auto &rest = row.at_rest, &end = row.at_terminal;
    Json torques = Json::array();
    for (const double torque : row.torques)
      torques.push_back(if_finite(torque)); // NaN: no balance
    list.push_back({ { "closure", ring::to_string(row.closure) },
                     { "load", row.load },
                     { "harmonics", row.harmonics },
                     { "all_harmonics", row.all_harmonics },
                     { "amplitude", row.amplitude() },
                     { "tau_at_rest", number_of(rest, torque_of) },
                     { "lean_torque_at_rest", number_of(rest, &RingState::lean_torque) },
                     { "torque", torques },
                     { "omega_terminal", row.omega_terminal() },
                     { "omega_terminal_band", row.band },
                     { "tau_at_terminal", number_of(end, torque_of) },
                     { "lean_torque_at_terminal", number_of(end, &RingState::lean_torque) },
                     { "grip_torque_at_terminal", number_of(end, &RingState::grip_torque) },
                     { "force_at_terminal", number_of(end, force_of) },
                     { "time_constant", row.time_constant() },
                     { "relative_change", row.relative_change },
                     { "difference_to_paper", row.difference_to_paper },
                     { "spin_up_deviation", row.largest_deviation },
                     { "spin_up_deviation_at_end", row.final_deviation },
                     { "bound", row.bound },
                     { "pulls", row.pulls() },
                     { "pulls_with", row.pulls() ? Json(row.pulling_share()) : Json(nullptr) },
                     { "least_load", row.least_load() },
                     { "load_minimum", number_of(rest, &RingState::minimum) },
                     { "load_minimum_at_terminal", number_of(end, &RingState::minimum) },
                     { "pulling_share", number_of(rest, &RingState::pulling_share) },
                     { "pulling_share_at_terminal", number_of(end, &RingState::pulling_share) },
                     { "moment_ratio_at_rest", number_of(rest, &RingState::moment_ratio) },
                     { "moment_ratio_at_terminal", number_of(end, &RingState::moment_ratio) },
                     { "ring_radius_at_terminal",
                       number_of(end, [](const RingState &state) { return state.load.radius(); }) },
                     { "load_at_terminal", number_of(end, load_of) },
                     { "contact_fraction_at_terminal", row.contact_fraction },
                     { "state", to_string(row.standing) },
                     { "message", if_said(row.reason) } });
  }
  return list;
}

Json shown_spin_rows(const std::vector<SpinRow> &rows)
{
  constexpr double small_change = 1e-11;
  Json shown = spin_rows(rows);
  const auto &rest = rows.back().at_rest;
  leave_out_rounding(shown, "tau_at_rest torque", rest ? 1e-12 * std::abs(torque_of(*rest)) : 0);
  leave_out_rounding(shown, "relative_change", small_change);
  leave_out_rounding(shown, "spin_up_deviation spin_up_deviation_at_end",
                     small_change * std::abs(rows.back().omega_terminal().value_or(0)));
  return shown;
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

} // namespace stemware::pipeline
