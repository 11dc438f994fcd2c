#include "fem/pipeline/report/spin_table.h"

#include "fem/pipeline/report/common_sections.h"
#include "fem/pipeline/report/quantities.h"

#include <cmath>

namespace stemware::pipeline
{

namespace
{

/// A number of a row's load at rest, or at its terminal spin; nothing where there is no such load.
template <typename Value>
auto of_state(std::optional<RingState> SpinRow::*state, Value value)
{
  return [=](const SpinRow &row) -> std::optional<double>
  {
    if (const std::optional<RingState> &present = row.*state)
      return std::invoke(value, *present);
    return std::nullopt;
  };
}

nlohmann::ordered_json series_at_terminal(const SpinRow &row)
{
  if (!row.at_terminal)
    return nullptr;
  nlohmann::ordered_json summary = series_summary(row.at_terminal->load);
  summary["ring_radius"] = row.at_terminal->load.radius();
  summary["moment_ratio"] = row.at_terminal->moment_ratio;
  return summary;
}

std::optional<std::string> reason_of(const SpinRow &row)
{
  return row.reason.empty() ? std::nullopt : std::optional(row.reason);
}

} // namespace

Table spin_table(const std::vector<SpinRow> &rows, const std::vector<double> &omega)
{
  const auto at_rest = &SpinRow::at_rest, at_terminal = &SpinRow::at_terminal;
  const auto torque = [](const RingState &state) { return state.friction.torque; };
  const auto radius = [](const RingState &state) { return state.load.radius(); };
  const SpinRow &all = rows.back();
  const double small_change = 1e-11;
  const double small_spin = small_change * std::abs(all.omega_terminal().value_or(0));
  const double small_torque = 1e-12 * std::abs(of_state(at_rest, torque)(all).value_or(0));
  Table table = {
    "",
    { column(quantity::closure, rows, [](const SpinRow &row) { return ring::to_string(row.closure); }),
      column(quantity::load, rows, &SpinRow::load),
      column(quantity::harmonics, rows, &SpinRow::harmonics),
      column(quantity::all_harmonics, rows, &SpinRow::all_harmonics),
      column(quantity::amplitude, rows, &SpinRow::amplitude),
      column(quantity::tau_at_rest, rows, of_state(at_rest, torque), small_torque),
      column(quantity::omega_terminal, rows, &SpinRow::omega_terminal),
      column(quantity::omega_terminal_band, rows, &SpinRow::band),
      column(quantity::relative_change, rows, &SpinRow::relative_change, small_change),
      column(quantity::difference_to_paper, rows, &SpinRow::difference_to_paper),
      column(quantity::spin_up_deviation, rows, &SpinRow::largest_deviation, small_spin),
      column(quantity::spin_up_deviation_at_end, rows, &SpinRow::final_deviation, small_spin),
      column(quantity::bound, rows, &SpinRow::bound),
      column(quantity::pulls, rows, &SpinRow::pulls),
      column(quantity::formal, rows, [](const SpinRow &row) { return row.pulls() ? "formal" : ""; }),
      column(quantity::pulls_with, rows,
             [](const SpinRow &row)
             { return row.pulls() ? std::optional(row.pulling_share()) : std::nullopt; }),
      column(quantity::least_load, rows, &SpinRow::least_load),
      column(quantity::load_minimum, rows, of_state(at_rest, &RingState::minimum)),
      column(quantity::load_minimum_at_terminal, rows, of_state(at_terminal, &RingState::minimum)),
      column(quantity::pulling_share, rows, of_state(at_rest, &RingState::pulling_share)),
      column(quantity::pulling_share_at_terminal, rows, of_state(at_terminal, &RingState::pulling_share)),
      column(quantity::moment_ratio_at_rest, rows, of_state(at_rest, &RingState::moment_ratio)),
      column(quantity::moment_ratio_at_terminal, rows, of_state(at_terminal, &RingState::moment_ratio)),
      column(quantity::ring_radius_at_terminal, rows, of_state(at_terminal, radius)),
      column(quantity::load_at_terminal, rows, series_at_terminal),
      column(quantity::contact_fraction_at_terminal, rows, &SpinRow::contact_fraction),
      column(quantity::state, rows, [](const SpinRow &row) { return to_string(row.standing); }),
      column(quantity::message, rows, reason_of) }
  };
  for (std::size_t i = 0; i < omega.size(); ++i)
    table.columns.push_back(column(
      quantity::torque_at(omega[i]), rows,
      [=](const SpinRow &row) -> std::optional<double>
      {
        const double value = row.torques.at(i); // NaN: no balance
        return std::isnan(value) ? std::nullopt : std::optional(value);
      },
      small_torque));
  return table;
}

} // namespace stemware::pipeline
