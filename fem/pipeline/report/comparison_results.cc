#include "fem/pipeline/report/comparison_results.h"

#include "fem/pipeline/report/answer.h"
#include "fem/pipeline/report/budget_tables.h"
#include "fem/pipeline/report/common_sections.h"
#include "fem/pipeline/report/plots/plots.h"
#include "fem/pipeline/report/quantities.h"
#include "fem/pipeline/report/render/table_renderers.h"
#include "fem/pipeline/report/spin_table.h"

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
Table row_table(const Comparison &comparison)
{
  Table table =
    spin_table(comparison.rows)
      .with("", "closure load harmonics all_harmonics tau_at_rest moment_ratio_at_rest omega_terminal "
                "omega_terminal_band difference_to_paper load_minimum_at_terminal "
                "contact_fraction_at_terminal state message");
  const auto effect = [&](std::optional<double> HarmonicEffect::*value)
  {
    return [&, value](const SpinRow &row)
    { return row.all_harmonics ? comparison.harmonic_effect(row.closure, row.load).*value : std::nullopt; };
  };
  const auto before = table.columns.end() - 2; // state and message stay the last
  table.columns.insert(
    before,
    { column(quantity::harmonic_effect, comparison.rows, effect(&HarmonicEffect::absolute)),
      column(quantity::harmonic_effect_relative, comparison.rows, effect(&HarmonicEffect::relative)) });
  return table;
}

Findings findings_of(const Study &study, const Comparison &comparison)
{
  const std::string &load = comparison.rows.back().load; // the study's own, the last
  const SpinRow *own = comparison.find(study.motion.closure, load);
  const HarmonicEffect effect = comparison.harmonic_effect(study.motion.closure, load);
  Findings findings;
  findings.key_figures = { { "omega_terminal", json_number(own->omega_terminal()) },
                           { "omega_terminal_band", json_number(own->band) },
                           { "harmonic_effect", json_number(effect.absolute) },
                           { "harmonic_effect_relative", json_number(effect.relative) } };
  findings.summary = { { "harmonic_effect", harmonic_effect_summary(effect) },
                       { "budget", budget_summary(study, chain_alone(comparison.budget)) },
                       { "comparison", json_table(row_table(comparison)) } };
  return findings;
}

/// A terminal spin with its state: on the console "f" marks formal loads.
std::string spin_text(const SpinRow &row, bool on_console)
{
  if (!row.omega_terminal())
    return on_console ? (row.standing == Standing::tips ? "tips  " : "none  ") : to_string(row.standing);
  const bool is_formal = row.standing == Standing::formal;
  return format::all_significant<6>(*row.omega_terminal()) +
         (on_console ? (is_formal ? " f" : "  ") : (is_formal ? " (formal)" : ""));
}

/// Terminal spins: loads and truncations down, moment balances along; down a column what the harmonics do,
/// along a row what the moment balances do.
Table overview_table(const Comparison &comparison)
{
  Table table = { "Terminal spin (rad/s) by load and harmonics kept, and by moment balance",
                  { column(quantity::load, rows_of(comparison, Closure::paper),
                           [](const SpinRow &row) { return load_title(row, "≤"); }) } };
  for (const Closure closure : closures)
  {
    const std::vector<SpinRow> rows = rows_of(comparison, closure);
    table.columns.push_back(column(Quantity("", "", "1", ring::to_string(closure)), rows,
                                   [](const SpinRow &row) { return spin_text(row, false); }));
    table.columns.push_back(column(quantity::difference_to_paper, rows, &SpinRow::difference_to_paper));
  }
  return table;
}

/// For the console: the terminal spin of each load with all its harmonics, and what those beyond the first do
/// to it under the @p own moment balance of the study.
Table console_overview(const Comparison &comparison, Closure own)
{
  const auto of_all_harmonics = [&](Closure closure)
  {
    std::vector<SpinRow> rows = rows_of(comparison, closure);
    rows.erase(
      std::remove_if(rows.begin(), rows.end(), [](const SpinRow &row) { return !row.all_harmonics; }),
      rows.end());
    return rows;
  };
  Table table = { "",
                  { column(quantity::load, of_all_harmonics(Closure::paper),
                           [](const SpinRow &row) { return name_of_load(row.load); }) } };
  for (const Closure closure : closures)
  {
    const std::string name = ring::to_string(closure);
    table.columns.push_back(column(Quantity("", "", "1", name, name + "\n(rad/s)  "),
                                   of_all_harmonics(closure),
                                   [](const SpinRow &row) { return spin_text(row, true); }));
  }
  table.columns.push_back(column(
    quantity::harmonic_effect.with(&Quantity::label, "harmonics,\nclosure " + ring::to_string(own)),
    of_all_harmonics(own),
    [&](const SpinRow &row) { return comparison.harmonic_effect(row.closure, row.load).absolute; },
    1e-9 * comparison.spin_scale));
  return table;
}

/// All rows of one moment balance, for the report.
Table closure_table(const Comparison &comparison, Closure closure)
{
  const std::vector<SpinRow> rows = rows_of(comparison, closure);
  Table table = spin_table(rows).with("Closure " + ring::to_string(closure),
                                      "load tau_at_rest moment_ratio_at_rest omega_terminal "
                                      "load_minimum_at_terminal contact_fraction_at_terminal state");
  table["omega_terminal"].digits = format::significant<7>;
  table.columns.front() =
    column(quantity::load, rows, [](const SpinRow &row) { return load_title(row, "≤"); });
  return table;
}

/// What the effect of harmonics is counted from: a foot leans on its table, a rim in closed form does not.
std::string reference_note(const Study &study)
{
  return std::string("each load against its own first harmonic") +
         (study.tilts() ? ", with tilt for a foot, without for the rims" : "");
}

ReportSection overview_section(const Study &study, const Comparison &comparison)
{
  return {
    "Harmonics beside moment balances",
    "Closure paper balances the centripetal part of the hand's force alone, hand the whole force of the "
    "hand, full also the moment of the friction about the centre of mass. In all rows but those of the "
    "elastic foot at rest (one-way: that load is kept at every spin), the load is computed anew at each "
    "spin, "
    "in balance with friction. With n = 1 the rigid rims coincide with the first row, whatever they stand "
    "on. "
    "Formal: the load, or what is left of it, would have to pull on the table. What the harmonics do is "
    "counted " +
      reference_note(study) + ".",
    { comparison_plot(comparison), harmonic_effect_plot(comparison) },
    { overview_table(comparison) }
  };
}

ReportSection table_section(const Comparison &comparison)
{
  ReportSection section = {
    "All rows",
    "m is the moment ratio |M_N| / (N R / 2). The least load is that of the harmonics kept, the rim that "
    "carries that of the contact itself, both at the terminal spin."
  };
  for (const Closure closure : closures)
    section.tables.push_back(closure_table(comparison, closure));
  for (const SpinRow &row : comparison.rows)
    if (!row.reason.empty())
      section.text += fmt::format(FMT_STRING("\n\n{}, closure {}, harmonics {}: {}."), name_of_load(row.load),
                                  ring::to_string(row.closure), harmonics_name(row), row.reason);
  return section;
}

std::vector<ConsoleBlock> console_of(const std::string &answer, const Study &study,
                                     const Comparison &comparison)
{
  Budget steps = chain_alone(comparison.budget);
  steps.rows = named_steps(steps.rows);
  std::vector<ConsoleBlock> blocks = { { answer },
                                       chain_block(study, steps),
                                       { "Terminal spin by load, all its harmonics kept, and by moment "
                                         "balance, and what the harmonics beyond the first do to it, " +
                                           reference_note(study) + ":",
                                         console_overview(comparison, study.motion.closure) } };
  if (std::any_of(comparison.rows.begin(), comparison.rows.end(),
                  [](const SpinRow &row)
                  { return row.omega_terminal() && row.standing == Standing::formal; }))
    blocks.push_back({ "f  formal: the load, or what is left of it, would have to pull on the table" });
  std::string reasons;
  for (const SpinRow &row : comparison.rows)
    if (row.all_harmonics && !row.reason.empty())
      reasons += fmt::format(FMT_STRING("closure {}, {}: {}. {}\n"), ring::to_string(row.closure),
                             name_of_load(row.load), to_string(row.standing), row.reason);
  if (!reasons.empty())
    blocks.push_back({ reasons });
  return blocks;
}

} // namespace

Results tabulate(const Study &study, const Comparison &comparison)
{
  Table csv = row_table(comparison)
                .with("", "closure load harmonics all_harmonics tau_at_rest moment_ratio_at_rest "
                          "omega_terminal difference_to_paper load_minimum_at_terminal "
                          "contact_fraction_at_terminal harmonic_effect harmonic_effect_relative state "
                          "message");
  csv["harmonics"].unit = "";
  csv["load_minimum_at_terminal"].name = "least load at terminal omega";
  Results results;
  results.files = { { "compare.csv", "all rows", csv },
                    { "summary.json", "all numbers, for programs" },
                    { "parameters.prm", "the study, to be run again" },
                    { "timings.json", "how long it took" } };
  results.report = { "What changes the spin of a wine glass",
                     comparison_answer(comparison),
                     { chain_section(study, chain_alone(comparison.budget)),
                       overview_section(study, comparison), table_section(comparison) } };
  add_closing_sections(results.report, study, results.files);
  results.console = console_of(results.report.answer, study, comparison);
  results.findings = findings_of(study, comparison);
  return results;
}

} // namespace stemware::pipeline
