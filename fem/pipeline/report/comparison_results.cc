#include "fem/pipeline/report/comparison_results.h"

#include "fem/pipeline/document/spin_rows.h"
#include "fem/pipeline/report/common_sections.h"
#include "fem/pipeline/report/head.h"
#include "fem/pipeline/report/plots/plots.h"

#include <algorithm>

namespace stemware::pipeline
{

namespace
{

using Json = nlohmann::ordered_json;
using ring::Closure;
constexpr Closure closures[] = { Closure::paper, Closure::hand, Closure::full };

/// "3", or "all".
std::string harmonics_name(const SpinRow &row)
{
  return row.all_harmonics && row.harmonics > 1 ? "all" : std::to_string(row.harmonics);
}

/// "elastic foot, n <= 2", with @p at_most for the sign.
std::string load_title(const SpinRow &row, const std::string &at_most)
{
  const std::string load = name_of_load(row.load);
  if (row.harmonics == 1)
    return row.load == compared_load::first_harmonic ? load : load + ", n = 1";
  return load + (row.all_harmonics ? ", all" : ", n " + at_most + " " + std::to_string(row.harmonics));
}

std::vector<SpinRow> rows_of(const Comparison &comparison, Closure closure)
{
  std::vector<SpinRow> rows;
  std::copy_if(comparison.rows.begin(), comparison.rows.end(), std::back_inserter(rows),
               [=](const SpinRow &row) { return row.closure == closure; });
  return rows;
}

/// All numbers of all rows; what the harmonics beyond the first do stands in the rows of all harmonics.
Json comparison_rows(const Comparison &comparison)
{
  Json rows = spin_rows(comparison.rows);
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    const SpinRow &row = comparison.rows[i];
    const HarmonicEffect effect =
      row.all_harmonics ? comparison.harmonic_effect(row.closure, row.load) : HarmonicEffect();
    rows[i]["harmonic_effect"] = effect.absolute;
    rows[i]["harmonic_effect_relative"] = effect.relative;
  }
  return declared(rows, "comparison");
}

/// A terminal spin with its state: on the console "f" marks formal loads.
std::string spin_text(const SpinRow &row, bool on_console)
{
  if (!row.omega_terminal())
    return on_console ? (row.standing == Standing::tips ? "tips  " : "none  ") : to_string(row.standing);
  const bool is_formal = row.standing == Standing::formal;
  return format::number(*row.omega_terminal(), "#.6g") +
         (on_console ? (is_formal ? " f" : "  ") : (is_formal ? " (formal)" : ""));
}

/// Terminal spins: loads and truncations down, moment balances along; down a column what the harmonics do,
/// along a row what the moment balances do.
Json overview_rows(const Comparison &comparison)
{
  Json rows = Json::array();
  for (const SpinRow &row : rows_of(comparison, Closure::paper))
    rows.push_back({ { "load", load_title(row, "≤") } });
  for (const Closure closure : closures)
  {
    const std::string name = ring::to_string(closure);
    std::size_t i = 0;
    for (const SpinRow &row : rows_of(comparison, closure))
    {
      rows.at(i)[name] = spin_text(row, false);
      rows.at(i++)[name + "_against"] = row.difference_to_paper;
    }
  }
  return rows;
}

/// For the console: the terminal spin of each load with all its harmonics, and what those beyond the first do
/// to it under the @p own moment balance of the study.
Json console_overview(const Comparison &comparison, Closure own)
{
  Json rows = Json::array();
  for (const SpinRow &each : rows_of(comparison, Closure::paper))
    if (each.all_harmonics)
    {
      Json row = { { "load", name_of_load(each.load) } };
      for (const Closure closure : closures)
        row[ring::to_string(closure)] = spin_text(*comparison.find(closure, each.load), true);
      row["harmonic_effect"] = comparison.harmonic_effect(own, each.load).absolute;
      rows.push_back(row);
    }
  leave_out_rounding(rows, "harmonic_effect", 1e-9 * comparison.spin_scale);
  return rows;
}

/// All rows of one moment balance, for the report.
Json closure_rows(const Comparison &comparison, Closure closure)
{
  const std::vector<SpinRow> spins = rows_of(comparison, closure);
  Json rows = shown_spin_rows(spins);
  for (std::size_t i = 0; i < rows.size(); ++i)
    rows[i]["load"] = load_title(spins[i], "≤");
  return rows;
}

/// Note on the reference of the harmonics' effect: a foot leans on its table, a rim in closed form does not.
std::string reference_note(const Study &study)
{
  return std::string("each load against its own first harmonic") +
         (study.tilts() ? ", with tilt for a foot, without for the rims" : "");
}

/// "-3.12056 rad/s", or why there is none.
std::string spin_with_unit(const SpinRow &row)
{
  if (!row.omega_terminal())
    return "nothing (" + to_string(row.standing) + ")";
  return format::with_band(*row.omega_terminal(), row.band) + " rad/s" +
         (row.standing == Standing::formal ? ", formally" : "");
}

/// spin_with_unit() of all harmonics of the study's own load, the last one, and what those beyond the first
/// do.
std::string own_spin(const Comparison &comparison, Closure closure)
{
  const std::string &load = comparison.rows.back().load;
  const HarmonicEffect effect = comparison.harmonic_effect(closure, load);
  std::string text = spin_with_unit(*comparison.find(closure, load));
  if (!effect.absolute)
    return text;
  if (std::abs(*effect.absolute) < 1e-9 * comparison.spin_scale)
    return text + " (harmonics: 0)";
  return text + " (harmonics: " + format::number(*effect.absolute, "+.3g") + " rad/s" +
         (effect.relative ? ", " + format::number(*effect.relative, "+.3g%") : "") + ")";
}

Json facts_of(const Study &study, const Comparison &comparison)
{
  const auto &rows = comparison.rows;
  const SpinRow &paper = *comparison.find(Closure::paper, compared_load::first_harmonic),
                &full = *comparison.find(Closure::full, compared_load::first_harmonic);
  const auto before = paper.omega_terminal(), after = full.omega_terminal();
  const auto change =
    before && after ? relative_to(before, *after - *before, comparison.spin_scale) : std::optional<double>();
  Json reasons = Json::array();
  for (const SpinRow &row : rows)
    if (!row.reason.empty())
      reasons.push_back({ { "load", name_of_load(row.load) },
                          { "closure", ring::to_string(row.closure) },
                          { "harmonics", harmonics_name(row) },
                          { "all_harmonics", row.all_harmonics },
                          { "standing", to_string(row.standing) },
                          { "reason", row.reason } });
  const auto spins = [&](const SpinRow &row)
  { return std::abs(row.omega_terminal().value_or(0)) >= 1e-9 * comparison.spin_scale; };
  const auto is_formal = [](const SpinRow &row)
  { return row.omega_terminal() && row.standing == Standing::formal; };
  return { { "spins", std::any_of(rows.begin(), rows.end(), spins) },
           { "paper_first", spin_with_unit(paper) },
           { "full_first", spin_with_unit(full) },
           { "change", change ? format::number(*change, "+.3g%") : "" },
           { "own_load", name_of_load(rows.back().load) },
           { "paper_all", own_spin(comparison, Closure::paper) },
           { "full_all", own_spin(comparison, Closure::full) },
           { "counted_from", reference_note(study) },
           { "has_formal", std::any_of(rows.begin(), rows.end(), is_formal) },
           { "reasons", reasons } };
}

} // namespace

std::vector<TurningGlass> add_models(const Study &study, const Comparison &comparison, Document &document)
{
  const std::string &load = comparison.rows.back().load; // the study's own, the last
  const Closure own = study.motion.closure;
  const SpinRow &own_row = *comparison.find(own, load);
  const HarmonicEffect effect = comparison.harmonic_effect(own, load);
  Budget budget;
  budget.rows = comparison.budget;
  document.findings.key_figures = { { "omega_terminal", own_row.omega_terminal() },
                                    { "omega_terminal_band", own_row.band },
                                    { "harmonic_effect", effect.absolute },
                                    { "harmonic_effect_relative", effect.relative } };
  document.findings.summary["harmonic_effect"] = harmonic_effect_summary(effect);
  document.findings.summary["budget"] = budget_summary(study, budget.rows);
  document.facts.update(facts_of(study, comparison));
  add_chain(study, budget, document);
  add_comparison_plots(comparison, document);
  document.facts["overview"] = overview_rows(comparison);
  document.facts["console_overview"] = console_overview(comparison, own);
  document.quantities["console_overview"]["harmonic_effect"]["label"] =
    "harmonics,\nclosure " + ring::to_string(own);
  for (const Closure closure : closures)
    document.facts["closures"][ring::to_string(closure)] = closure_rows(comparison, closure);
  const auto spin = [&](Closure closure, const std::string &of_load)
  { return comparison.find(closure, of_load)->omega_terminal(); };
  return { { "complete balance", spin(Closure::full, load) },
           { "the paper's rigid ring", spin(Closure::paper, compared_load::first_harmonic), {}, true } };
}

Results tabulate(const std::string &verb, const Study &study, const Comparison &comparison,
                 ShownBeside add_own)
{
  Document document;
  document.facts["rows"] = shown_spin_rows(comparison.rows);
  std::vector<TurningGlass> glasses;
  for (const SpinRow &row : comparison.rows)
    if (row.all_harmonics)
      glasses.push_back({ row.load, row.omega_terminal() });
  add_study(study, add_own ? add_own(study, comparison, document) : glasses, document);
  document.findings.summary["comparison"] = comparison_rows(comparison);
  return shown(document, verb);
}

} // namespace stemware::pipeline
