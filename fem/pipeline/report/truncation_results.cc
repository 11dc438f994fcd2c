#include "fem/pipeline/report/truncation_results.h"

#include "fem/pipeline/document/spin_rows.h"
#include "fem/pipeline/report/common_sections.h"
#include "fem/pipeline/report/head.h"
#include "fem/pipeline/report/plots/plots.h"

#include <algorithm>
#include <cmath>

namespace stemware::pipeline
{

namespace
{

using Json = nlohmann::ordered_json;

constexpr char data_keys[] =
  "harmonics amplitude tau_at_rest omega_terminal relative_change spin_up_deviation "
  "spin_up_deviation_at_end bound ring_radius_at_terminal "
  "moment_ratio_at_terminal load_minimum load_minimum_at_terminal pulling_share "
  "pulling_share_at_terminal pulls torque[]";

/// The rows up to the first whose terminal spin is that of all harmonics, to within its band or 1e-9, and the
/// last.
std::vector<SpinRow> rows_that_differ(const TruncationStudy &study)
{
  const std::vector<SpinRow> &rows = study.rows;
  const double spin = std::abs(study.all().omega_terminal().value_or(0));
  const double small = std::max(1e-9, spin > 0 ? study.all().band.value_or(0) / spin : 0);
  const auto is_settled = [=](const SpinRow &row)
  { return row.relative_change && std::abs(*row.relative_change) < small; };
  const auto settled = std::find_if(rows.begin(), rows.end(), is_settled);
  std::vector<SpinRow> shown(rows.begin(), settled);
  if (settled != rows.end())
    shown.push_back(*settled);
  if (settled != rows.end() && settled + 1 != rows.end())
    shown.push_back(rows.back());
  return shown;
}

/// omega(t) by the number of harmonics; truncations without a spin-up are left out.
Table spin_up_table(const TruncationStudy &study)
{
  Table table = { "", { numbers("time", "s", study.time) } };
  for (const SpinRow &row : study.rows)
    if (!row.spin_up.empty())
      table.columns.push_back(
        numbers("omega, harmonics up to " + std::to_string(row.harmonics), "rad/s", row.spin_up));
  return table;
}

Findings findings_of(const LoadReport &load, const TruncationStudy &study, const Json &budget)
{
  Json rows = spin_rows(study.rows);
  for (Json &row : rows)
    row["trouble"] = row["message"];
  Findings findings;
  findings.summary = { { "load", load_summary(load) },
                       { "torque_at", study.omega },
                       { "harmonic_effect", harmonic_effect_summary(study.harmonics) },
                       { "budget", budget },
                       { "truncation", declared(rows, "truncation") } };
  findings.key_figures = { { "omega_terminal", study.all().omega_terminal() },
                           { "omega_terminal_band", study.all().band },
                           { "harmonic_effect", study.harmonics.absolute },
                           { "harmonic_effect_relative", study.harmonics.relative },
                           { "harmonics_for_1e-4", harmonics_enough(study.rows, 1e-4) } };
  return findings;
}

/// The names of the torques at the spins that were asked for.
Json torque_quantities(const std::vector<double> &spins)
{
  Json list = Json::array();
  for (const double omega : spins)
    list.push_back({ { "name", "tau_z at omega = " + format::number(omega, ".9g") + " rad/s" },
                     { "unit", "N m" },
                     { "heading", "τ_z at " + format::number(omega, ".6g") + " rad/s" } });
  return list;
}

// ---- report

/// Title in keys of a load truncated after @p n of @p n_all harmonics.
std::string truncation_title(unsigned int n, unsigned int n_all)
{
  if (n == 1)
    return "first harmonic";
  return (n == n_all ? "all, n ≤ " : "n ≤ ") + std::to_string(n);
}

/// Spin-ups with 1, 2, 3 and all harmonics, in the colours of add_torque_plot(), and the paper's.
std::vector<SpinCurve> shown_spin_ups(const TruncationStudy &study)
{
  const unsigned int n_all = study.all().harmonics;
  std::vector<SpinCurve> curves = { { truncation_title(n_all, n_all), study.all().spin_up, 1 } };
  for (const SpinRow &row : study.rows)
    if (row.harmonics <= 3 && row.harmonics < n_all && !row.spin_up.empty())
      curves.push_back({ truncation_title(row.harmonics, n_all), row.spin_up, row.harmonics + 1 });
  curves.push_back({ "the paper's model", study.paper, 7 });
  return curves;
}

Json facts_of(const Study &study, const TruncationStudy &truncations)
{
  const SpinRow &all = truncations.all();
  const double omega = all.omega_terminal().value();
  const bool is_spinning = is_spin(study, omega);
  const std::string held = is_spinning ? "" : held_by_the_grip(study, all);
  Json reasons = Json::array();
  for (const SpinRow &row : truncations.rows)
    if (!row.reason.empty())
      reasons.push_back({ { "harmonics", row.harmonics }, { "reason", row.reason } });
  Json facts = study_facts(study);
  facts.update({ { "held", held },
                 { "stays", !is_spinning && held.empty() },
                 { "one_harmonic", is_spinning && all.harmonics == 1 },
                 { "several_harmonics", is_spinning && all.harmonics > 1 },
                 { "with_band", format::with_band(omega, all.band) },
                 { "n_harmonics", all.harmonics },
                 { "first", truncations.rows.front().omega_terminal() },
                 { "effect", effect_facts(study, truncations.harmonics) },
                 { "n_enough", harmonics_enough(truncations.rows, 1e-4) },
                 { "has_changes", all.relative_change && truncations.rows.size() > 1 },
                 { "has_deviations", truncations.rows.size() > 1 },
                 { "reasons", reasons } });
  return facts;
}

} // namespace

unsigned int harmonics_enough(const std::vector<SpinRow> &rows, double share)
{
  unsigned int enough = rows.back().harmonics;
  for (auto row = rows.rbegin(); row != rows.rend(); ++row)
  {
    if (!row->relative_change || std::abs(*row->relative_change) > share)
      break;
    enough = row->harmonics;
  }
  return enough;
}

Results tabulate(const Study &study, const LoadReport &load, const TruncationStudy &truncations,
                 const ErrorBands &bands)
{
  Budget budget;
  budget.rows = truncations.budget;
  Document document = { findings_of(load, truncations, budget_summary(study, budget.rows)),
                        facts_of(study, truncations) };
  std::vector<TurningGlass> glasses = { { "all harmonics", truncations.all().omega_terminal() },
                                        { "the first alone", truncations.rows.front().omega_terminal() } };
  add_study(study, glasses, document, load.rings);
  add_chain(study, budget, document);
  document.plots["terminal_spin"] = { { "bound_scale", std::abs(truncations.torque_slope *
                                                                truncations.all().omega_terminal().value()) },
                                      { "rounding", 1e-13 } };
  add_torque_plot(truncations.torque, truncations.rows, document);
  add_spin_up_plot(truncations.time, shown_spin_ups(truncations), truncations.all(), {},
                   "Spin-up from rest, n harmonics kept, beside the paper's result.", document);
  add_deviation_plot(truncations.rows, document);
  add_load(study, load, bands, document);
  document.facts["truncation_keys"] = data_keys;
  document.facts["truncations"] = { { "rows", spin_rows(truncations.rows) },
                                    { "shown", shown_spin_rows(truncations.rows) },
                                    { "differing", shown_spin_rows(rows_that_differ(truncations)) } };
  document.quantities = { { "truncations", { { "torque[]", torque_quantities(truncations.omega) } } } };
  document.tables["torque"] = torque_table(truncations.torque);
  document.tables["spin_up"] = spin_up_table(truncations);
  return shown(document, "truncate");
}

} // namespace stemware::pipeline
