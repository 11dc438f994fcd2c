#include "fem/pipeline/analysis/ring_quantities.h"

#include <algorithm>
#include <cmath>

namespace stemware::pipeline
{

namespace
{

using Number = std::optional<double>;

std::string remark_of(const BudgetRow &row)
{
  if (!row.reason.empty())
    return row.reason;
  return row.omega_terminal && row.status != ring::Status::formal ? "" : to_string(row.status);
}

Number spin_above(const BudgetRow &row)
{
  return row.difference ? Number(*row.omega_terminal - *row.difference) : std::nullopt;
}

/// Blank heading of a column. A column with an empty heading would not be shown.
constexpr char no_heading[] = " ";

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
  return row.harmonics ? "harmonics, n " + at_most + ' ' + std::to_string(*row.harmonics) : "harmonics, all";
}

Fields<BudgetRow> chain_fields(double scale, const std::function<Json(double)> &shown_spin)
{
  return Fields<BudgetRow>{
    { "step", "", "1, 2, 2a, 3, 3a, 4 …", [](const BudgetRow &row) { return label_of(row.step); },
      in_file("step", "step of the chain of models"), on_page("step") },
    { "name", "", "Effect that the row adds.", &BudgetRow::name },
    { "title", "", "", [](const BudgetRow &row) { return title_of(row); },
      in_file("what is added", "addition to the model above"), on_page("what is added") },
    { "console_title", "", "", [](const BudgetRow &row) { return title_of(row, "<="); },
      on_console("model, row by row") },
    { "harmonics", "1", "Harmonics that enter friction and torque; \"all\".",
      [](const BudgetRow &row) { return row.harmonics ? Json(*row.harmonics) : Json("all"); },
      of_type({ { "type", { "integer", "string" } } }) },
    { "harmonics", "1", "", &BudgetRow::harmonics,
      in_file("harmonics kept, nan: all", "harmonics that act on the ring; empty: all") },
    { "omega_terminal", "rad/s", "Terminal spin.",
      [shown_spin](const BudgetRow &row) {
        return shown_spin && row.omega_terminal ? shown_spin(*row.omega_terminal) : Json(row.omega_terminal);
      },
      in_file("terminal omega", "terminal spin"), shown_as("terminal spin"), with_digits("#.4g"),
      of_type({ { "type", { "number", "null" } } }) },
    { "difference", "rad/s", "Change from the row above.", &BudgetRow::difference,
      in_file("difference of terminal omega", "difference of the terminal spin to the row above"),
      shown_as("difference"), with_digits("+.4g") },
    { "relative_difference", "1", "",
      [scale](const BudgetRow &row)
      {
        Number relative = relative_to(spin_above(row), row.difference, scale);
        drop_rounding(relative, 1e-9);
        return relative;
      },
      shown_as("relative"), with_digits("+.3g%") },
    { "band", "rad/s", "Half-width of the error band, for rows with a contact.", &BudgetRow::band,
      in_file("half-width of the error band of terminal omega",
              "half-width of the error band of the terminal spin"),
      shown_as("band"), with_digits("band") },
    { "remark", "", "", remark_of, shown_as(no_heading) },
    { "formal", "1", "", [](const BudgetRow &row) { return row.status == ring::Status::formal; },
      in_file("1 if the load is negative somewhere", "1: the load is negative somewhere") },
    { "torques", "N m", "Torque of friction at 0, half and all of the last row's terminal spin.",
      &BudgetRow::torques,
      with_places(
        { { "tau_at_rest", "N m", "", "tau_z at rest of the last row", "torque of friction at rest" },
          { "tau_at_half", "N m", "", "tau_z at half the terminal spin of the last row",
            "torque of friction at half the terminal spin of the last row" },
          { "tau_at_terminal", "N m", "", "tau_z at the terminal spin of the last row",
            "torque of friction at the terminal spin of the last row" } }) },
    { "state", "", "Status of the row.", [](const BudgetRow &row) { return to_string(row.status); } },
    { "reason", "", "Reason for missing values.",
      [](const BudgetRow &row) { return text_or_null(row.reason); } }
  };
}

Fields<BudgetRow> chain_torque_fields()
{
  return { { "step", "", "", [](const BudgetRow &row) { return label_of(row.step); }, on_page("step") },
           { "title", "", "", [](const BudgetRow &row) { return title_of(row); }, on_page("what is added") },
           { "torques", "N m", "", &BudgetRow::torques,
             with_places({ { "torques[0]", "N m", "", "", "", "rest" },
                           { "torques[1]", "N m", "", "", "", "half the terminal spin" },
                           { "torques[2]", "N m", "", "", "", "the terminal spin" } }) } };
}

std::vector<BudgetRow> named_steps(const std::vector<BudgetRow> &rows)
{
  std::vector<BudgetRow> steps;
  std::optional<double> first; // terminal spin with the first harmonic only
  for (const BudgetRow &row : rows)
  {
    if (row.name != "harmonics" || steps.empty() || steps.back().name != "harmonics")
    {
      first = spin_above(row);
      steps.push_back(row);
      continue;
    }
    steps.back() = row;
    steps.back().difference =
      first && row.omega_terminal ? std::optional(*row.omega_terminal - *first) : std::nullopt;
  }
  return steps;
}

std::vector<BudgetRow> shown_chain(const std::vector<BudgetRow> &rows, double rounding)
{
  if (rows.empty())
    return {};
  const double smallest = std::max(rows.back().band.value_or(0), rounding),
               torque_at_rest = std::abs(rows.back().torques[0].value_or(0));
  // Rows of harmonics with a small difference are omitted, so the other differences are computed again, from
  // the last row in `shown`.
  std::vector<BudgetRow> shown;
  for (BudgetRow row : rows)
  {
    if (row.name == "harmonics" && row.harmonics && row.difference && std::abs(*row.difference) < smallest)
      continue;
    if (row.omega_terminal && !shown.empty() && shown.back().omega_terminal)
      row.difference = *row.omega_terminal - *shown.back().omega_terminal + 0.; // + 0. avoids -0
    else
      row.difference = std::nullopt;
    shown.push_back(row);
  }
  for (BudgetRow &row : shown)
  {
    drop_rounding(row.omega_terminal, rounding);
    drop_rounding(row.difference, rounding);
    for (auto &torque : row.torques)
      drop_rounding(torque, 1e-9 * torque_at_rest);
  }
  return shown;
}

Fields<WithoutRow> without_fields(const std::optional<double> &complete, double scale)
{
  return Fields<WithoutRow>{
    { "name", "", "Omitted effect.", &WithoutRow::name, in_file("without", "effect that is left out"),
      shown_as("without") },
    { "omega_terminal", "rad/s", "Terminal spin without the effect.", &WithoutRow::omega_terminal,
      in_file("terminal omega", "terminal spin"), shown_as("terminal spin"), with_digits("#.4g") },
    { "difference", "rad/s", "Change from the complete model.", &WithoutRow::difference,
      in_file("difference of terminal omega", "difference of the terminal spin to the complete model"),
      shown_as("difference"), with_digits("+.4g") },
    { "relative_difference", "1", "",
      [=](const WithoutRow &row)
      {
        Number relative = relative_to(complete, row.difference, scale);
        drop_rounding(relative, 1e-9);
        return relative;
      },
      shown_as("relative"), with_digits("+.3g%") },
    { "remark", "", "", &WithoutRow::reason, shown_as(no_heading) },
    { "reason", "", "Reason for a missing spin.",
      [](const WithoutRow &row) { return text_or_null(row.reason); },
      in_file("why there is none", "why the value is missing") }
  };
}

Fields<std::pair<std::string, double>> input_fields()
{
  using Row = std::pair<std::string, double>;
  return { { "name", "", "Changed input.", &Row::first },
           { "difference", "rad/s", "Change of the terminal spin, rigid ring with a first harmonic.",
             &Row::second } };
}

Fields<HarmonicEffect> harmonic_effect_fields()
{
  return { { "absolute", "rad/s", "Spin with all harmonics minus spin with the first only.",
             &HarmonicEffect::absolute },
           { "relative", "1",
             "Relative to the first harmonic only; null unless both spins have the same sense.",
             &HarmonicEffect::relative } };
}

} // namespace stemware::pipeline
