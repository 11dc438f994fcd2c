#include "fem/pipeline/output/comparison_results.h"

#include "fem/pipeline/output/answer.h"
#include "fem/pipeline/output/common_sections.h"
#include "fem/pipeline/output/plots/plots.h"
#include "fem/pipeline/output/quantities.h"
#include "fem/pipeline/output/render/table_renderers.h"
#include "fem/pipeline/output/spin_table.h"

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
  if (row.harmonics == 1)
    return row.load == compared_load::first_harmonic ? row.load : row.load + ", n = 1";
  return row.load + (row.all_harmonics ? ", all" : ", n " + at_most + " " + std::to_string(row.harmonics));
}

std::vector<SpinRow> rows_of(const Comparison &comparison, Closure closure)
{
  std::vector<SpinRow> rows;
  std::copy_if(comparison.rows.begin(), comparison.rows.end(), std::back_inserter(rows),
               [=](const SpinRow &row) { return row.closure == closure; });
  return rows;
}

Findings findings_of(const Comparison &comparison)
{
  const std::string &load = comparison.rows.back().load; // the study's own, the last
  const SpinRow *paper = comparison.find(Closure::paper, compared_load::first_harmonic);
  const SpinRow *full = comparison.find(Closure::full, compared_load::first_harmonic);
  const auto effect = [](const SpinRow *from, const SpinRow *to)
  { return json_number(relative_effect(from, to)); };
  const Json rows = json_table(
    spin_table(comparison.rows)
      .with("", "closure load harmonics all_harmonics tau_at_rest moment_ratio_at_rest omega_terminal "
                "omega_terminal_band difference_to_paper load_minimum_at_terminal "
                "contact_fraction_at_terminal state message"));
  Findings findings;
  findings.key_figures = {
    { "closure_effect", effect(paper, full) },
    { "harmonic_effect_closure_paper", effect(paper, comparison.find(Closure::paper, load)) },
    { "harmonic_effect_closure_full", effect(full, comparison.find(Closure::full, load)) }
  };
  findings.summary = { { "effects", findings.key_figures }, { "comparison", rows } };
  return findings;
}

/// Terminal spins: loads and truncations down, moment balances along; down a column what the harmonics do,
/// along a row what the moment balances do. On the console "f" marks formal loads.
Table overview_table(const Comparison &comparison, bool on_console)
{
  const auto load = [=](const SpinRow &row) { return load_title(row, on_console ? "<=" : "≤"); };
  const auto spin = [=](const SpinRow &row) -> std::string
  {
    if (!row.omega_terminal() && on_console)
      return row.standing == Standing::tips ? "tips  " : "none  ";
    if (!row.omega_terminal())
      return to_string(row.standing);
    const bool is_formal = row.standing == Standing::formal;
    return format::all_significant<6>(*row.omega_terminal()) +
           (on_console ? (is_formal ? " f" : "  ") : (is_formal ? " (formal)" : ""));
  };
  Table table = { on_console ? "" : "Terminal spin (rad/s) by load and harmonics kept, and by moment balance",
                  { column(quantity::load, rows_of(comparison, Closure::paper), load) } };
  for (const Closure closure : closures)
  {
    const std::vector<SpinRow> rows = rows_of(comparison, closure);
    const std::string name = ring::to_string(closure);
    table.columns.push_back(column(Quantity("", "", "1", name, name + "\n(rad/s)  "), rows, spin));
    table.columns.push_back(column(quantity::difference_to_paper, rows, &SpinRow::difference_to_paper));
  }
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

ReportSection overview_section(const Comparison &comparison)
{
  return {
    "Harmonics beside moment balances",
    "Closure paper balances the centripetal part of the hand's force alone, hand the whole force of the "
    "hand, full also the moment of the friction about the centre of mass. In all rows but those of the "
    "elastic foot at rest, the load is computed anew at each spin, in balance with friction. With n = 1 "
    "the rigid rims coincide with the first row, whatever they stand on. Formal: the load, or what is "
    "left of it, would have to pull on the table.",
    { comparison_plot(comparison) },
    { overview_table(comparison, false) }
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
      section.text += fmt::format(FMT_STRING("\n\n{}, closure {}, harmonics {}: {}."), row.load,
                                  ring::to_string(row.closure), harmonics_name(row), row.reason);
  return section;
}

std::vector<ConsoleBlock> console_of(const std::string &answer, const Comparison &comparison)
{
  std::vector<ConsoleBlock> blocks = { { answer },
                                       { "Terminal spin by load, harmonics kept and moment balance:",
                                         overview_table(comparison, true) } };
  if (std::any_of(comparison.rows.begin(), comparison.rows.end(),
                  [](const SpinRow &row)
                  { return row.omega_terminal() && row.standing == Standing::formal; }))
    blocks.push_back({ "f  formal: the load, or what is left of it, would have to pull on the table" });
  std::string reasons;
  for (const SpinRow &row : comparison.rows)
    if (row.all_harmonics && !row.reason.empty())
      reasons += fmt::format(FMT_STRING("closure {}, {}: {}. {}\n"), ring::to_string(row.closure), row.load,
                             to_string(row.standing), row.reason);
  if (!reasons.empty())
    blocks.push_back({ reasons });
  return blocks;
}

} // namespace

Results tabulate(const Study &study, const Comparison &comparison)
{
  Table csv = spin_table(comparison.rows)
                .with("", "closure load harmonics all_harmonics tau_at_rest moment_ratio_at_rest "
                          "omega_terminal difference_to_paper load_minimum_at_terminal "
                          "contact_fraction_at_terminal state message");
  csv["harmonics"].unit = "";
  csv["load_minimum_at_terminal"].name = "least load at terminal omega";
  Results results;
  results.files = { { "compare.csv", "all rows", csv },
                    { "summary.json", "all numbers, for programs" },
                    { "parameters.prm", "the study, to be run again" },
                    { "timings.json", "how long it took" } };
  results.report = { "What changes the spin of a wine glass",
                     comparison_answer(comparison),
                     { overview_section(comparison), table_section(comparison) } };
  add_closing_sections(results.report, study, results.files);
  results.console = console_of(results.report.answer, comparison);
  results.findings = findings_of(comparison);
  return results;
}

} // namespace stemware::pipeline
