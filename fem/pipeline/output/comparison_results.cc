#include "fem/pipeline/output/comparison_results.h"

#include "fem/pipeline/output/answer.h"
#include "fem/pipeline/output/common_sections.h"
#include "fem/pipeline/output/plots/plots.h"
#include "fem/pipeline/output/quantities.h"
#include "fem/pipeline/output/render/table_renderers.h"

#include <algorithm>

namespace stemware::pipeline
{

namespace
{

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

/// A text that stays on one line: with no-break spaces.
std::string on_one_line_of_html(const std::string &text)
{
  std::string result;
  for (const char letter : text)
    result += letter == ' ' ? "\u00a0" : std::string(1, letter);
  return result;
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
  Findings findings;
  findings.key_figures = {
    { "closure_effect", effect(paper, full) },
    { "harmonic_effect_closure_paper", effect(paper, comparison.find(Closure::paper, load)) },
    { "harmonic_effect_closure_full", effect(full, comparison.find(Closure::full, load)) }
  };
  findings.summary = { { "effects", findings.key_figures },
                       { "comparison", json_table(comparison_table(comparison.rows)) } };
  return findings;
}

/// Terminal spins: loads and truncations down, moment balances along; down a column what the harmonics do,
/// along a row what the moment balances do.
Table overview_table(const Comparison &comparison)
{
  Table table = { "Terminal spin (rad/s) by load and harmonics kept, and by moment balance",
                  { column(quantity::load, rows_of(comparison, Closure::paper),
                           [](const SpinRow &row) { return on_one_line_of_html(load_title(row, "≤")); }) } };
  for (const Closure closure : closures)
  {
    const std::vector<SpinRow> rows = rows_of(comparison, closure);
    table.columns.push_back(column({ "", "", "", ring::to_string(closure), "" }, rows,
                                   [](const SpinRow &row)
                                   {
                                     if (!row.omega_terminal())
                                       return on_one_line_of_html(to_string(row.standing));
                                     return format::all_significant<6>(*row.omega_terminal()) +
                                            (row.standing == Standing::formal ? " (formal)" : "");
                                   }));
    table.columns.push_back(column(quantity::difference_to_paper, rows, &SpinRow::difference_to_paper));
  }
  return table;
}

/// overview_table() for the console: "f" marks formal loads.
Table console_overview(const Comparison &comparison)
{
  Table table = { "",
                  { column(quantity::load, rows_of(comparison, Closure::paper),
                           [](const SpinRow &row) { return load_title(row, "<="); }) } };
  for (const Closure closure : closures)
  {
    const std::vector<SpinRow> rows = rows_of(comparison, closure);
    table.columns.push_back(column({ "", "", "1", "", ring::to_string(closure) + "\n(rad/s)  " }, rows,
                                   [](const SpinRow &row) -> std::string
                                   {
                                     if (!row.omega_terminal())
                                       return row.standing == Standing::tips ? "tips  " : "none  ";
                                     return format::all_significant<6>(*row.omega_terminal()) +
                                            (row.standing == Standing::formal ? " f" : "  ");
                                   }));
    table.columns.push_back(column(quantity::difference_to_paper, rows, &SpinRow::difference_to_paper));
  }
  return table;
}

/// All rows of one moment balance, for the report.
Table closure_table(const Comparison &comparison, Closure closure)
{
  const std::vector<SpinRow> rows = rows_of(comparison, closure);
  Table table =
    comparison_table(rows).with("Closure " + ring::to_string(closure),
                                { "load", "tau_at_rest", "moment_ratio_at_rest", "omega_terminal",
                                  "load_minimum_at_terminal", "contact_fraction_at_terminal", "state" });
  table.columns.front() = column(
    quantity::load, rows, [](const SpinRow &row) { return on_one_line_of_html(load_title(row, "≤")); });
  table.columns.back() = column(
    quantity::state, rows, [](const SpinRow &row) { return on_one_line_of_html(to_string(row.standing)); });
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
      section.text += fmt::format(FMT_STRING("\n\n{}, closure {}, harmonics {}: {}."), row.load,
                                  ring::to_string(row.closure), harmonics_name(row), row.reason);
  return section;
}

std::vector<ConsoleBlock> console_of(const std::string &answer, const Comparison &comparison)
{
  std::vector<ConsoleBlock> blocks = {
    { answer }, { "Terminal spin by load, harmonics kept and moment balance:", console_overview(comparison) }
  };
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

Table comparison_table(const std::vector<SpinRow> &rows)
{
  const auto at_rest = [](auto value)
  {
    return [=](const SpinRow &row)
    { return row.at_rest ? std::optional<double>(value(*row.at_rest)) : std::nullopt; };
  };
  return { "",
           { column(quantity::closure, rows, [](const SpinRow &row) { return ring::to_string(row.closure); }),
             column(quantity::load, rows, &SpinRow::load),
             column(quantity::harmonics.in_units(""), rows, &SpinRow::harmonics),
             column(quantity::all_harmonics, rows, &SpinRow::all_harmonics),
             column(quantity::tau_at_rest, rows,
                    at_rest([](const RingState &state) { return state.friction.torque; })),
             column(quantity::moment_ratio_at_rest, rows,
                    at_rest([](const RingState &state) { return state.moment_ratio; })),
             column(quantity::omega_terminal.with_digits(format::significant<7>), rows,
                    &SpinRow::omega_terminal),
             column(quantity::omega_terminal_band, rows, &SpinRow::band),
             column(quantity::difference_to_paper, rows, &SpinRow::difference_to_paper),
             column(quantity::load_minimum_at_terminal.renamed("least load at terminal omega"), rows,
                    [](const SpinRow &row)
                    { return row.at_terminal ? std::optional(row.at_terminal->minimum) : std::nullopt; }),
             column(quantity::contact_fraction_at_terminal, rows, &SpinRow::contact_fraction),
             column(quantity::state, rows, [](const SpinRow &row) { return to_string(row.standing); }),
             column(quantity::message, rows,
                    [](const SpinRow &row)
                    { return row.reason.empty() ? std::nullopt : std::optional(row.reason); }) } };
}

Results comparison_results(const Study &study, const Comparison &comparison)
{
  Results results;
  results.files = { { "compare.csv", "all rows",
                      comparison_table(comparison.rows)
                        .with("", { "closure", "load", "harmonics", "all_harmonics", "tau_at_rest",
                                    "moment_ratio_at_rest", "omega_terminal", "difference_to_paper",
                                    "load_minimum_at_terminal", "contact_fraction_at_terminal", "state",
                                    "message" }) },
                    { "summary.json", "all numbers, for programs" },
                    { "parameters.prm", "the study, to be run again" },
                    { "timings.json", "how long it took" } };
  results.report = { "What changes the spin of a wine glass",
                     comparison_answer(comparison),
                     { overview_section(comparison), table_section(comparison) } };
  for (const ReportSection &section : study_sections(study))
    results.report.sections.push_back(section);
  results.report.sections.push_back(file_section(results.files));
  results.console = console_of(results.report.answer, comparison);
  results.findings = findings_of(comparison);
  return results;
}

} // namespace stemware::pipeline
