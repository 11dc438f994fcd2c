#include "fem/pipeline/output/comparison_report.h"

#include "fem/pipeline/output/comparison_tables.h"
#include "fem/pipeline/output/render/plots.h"
#include "fem/pipeline/output/study_sections.h"
#include "fem/pipeline/support/text_layout.h"

#include <algorithm>

namespace stemware::pipeline
{

namespace
{

std::vector<std::string> load_names(const Comparison &comparison)
{
  std::vector<std::string> names;
  for (const ComparisonRow &row : comparison.rows)
    if (std::find(names.begin(), names.end(), row.load) == names.end())
      names.push_back(row.load);
  return names;
}

/// Terminal spins as points, a line of its own for each kind of load, the first on top.
ReportFigure spin_figure(const Comparison &comparison)
{
  const std::vector<std::string> loads = load_names(comparison);
  CurvePlot plot;
  plot.name = "terminal_spins";
  plot.caption = "Terminal spin by load, all its harmonics kept, and by closure (colours).";
  plot.x = { "terminal spin (rad/s)" };
  plot.y = { "", false, std::pair(0.5, static_cast<double>(loads.size()) + 0.5) };
  // The SVG terminal takes texts for wider than they are, and would leave too much room for the names.
  plot.commands = "set lmargin at screen 0.3\nset key width 0\nset ytics (";
  for (std::size_t i = 0; i < loads.size(); ++i)
    plot.commands += (i ? ", '" : "'") + loads[i] + "' " + std::to_string(loads.size() - i);
  plot.commands += ")\nset grid x y\n";
  for (const ring::Closure closure : compared_closures)
  {
    Curve curve = { ring::to_string(closure), {}, {}, CurveStyle::points };
    for (std::size_t i = 0; i < loads.size(); ++i)
      if (const auto *row = comparison.find(closure, loads[i]); row->omega_terminal)
      {
        curve.x.push_back(*row->omega_terminal);
        curve.y.push_back(static_cast<double>(loads.size() - i));
      }
    if (!curve.x.empty())
      plot.curves.push_back(curve);
  }
  return curve_figure(plot);
}

/// A text that stays on one line: with no-break spaces.
std::string unbroken(const std::string &text)
{
  std::string result;
  for (const char letter : text)
    result += letter == ' ' ? "\u00a0" : std::string(1, letter);
  return result;
}

ReportTable closure_table(const Comparison &comparison, ring::Closure closure)
{
  ReportTable table = { "Closure " + ring::to_string(closure),
                        { "load", "τ_z at rest (N\u00a0m)", "m at rest", "terminal spin (rad/s)",
                          "least load (N/rad)", "rim that carries", "" },
                        {} };
  for (const ComparisonRow &row : comparison.rows)
    if (row.closure == closure)
      table.rows.push_back({ unbroken(load_title(row, "≤")), formatted_or("–", "%.7g", row.tau_at_rest),
                             formatted_or("–", "%.5g", row.moment_ratio),
                             formatted_or("–", "%.7g", row.omega_terminal),
                             formatted_or("–", "%.4g", row.least_load),
                             row.contact_fraction ? formatted("%.1f %%", 100 * *row.contact_fraction) : "–",
                             unbroken(row.state) });
  return table;
}

/// "−5.03205 (formal)", or why there is none.
std::string spin_cell(const ComparisonRow &row)
{
  if (!row.omega_terminal)
    return unbroken(row.state);
  return formatted("%#.6g", *row.omega_terminal) + (row.state == "formal" ? " (formal)" : "");
}

/// Loads and truncations by closures: down a column what the harmonics do, along a row what the closures do.
ReportTable overview_table(const Comparison &comparison)
{
  ReportTable table = { "Terminal spin (rad/s) by load and harmonics kept, and by closure", { "load" }, {} };
  for (const ring::Closure closure : compared_closures)
  {
    table.header.insert(table.header.end(), { ring::to_string(closure), "to the paper's" });
    std::size_t i = 0;
    for (const ComparisonRow &row : comparison.rows)
      if (row.closure == closure)
      {
        if (i == table.rows.size())
          table.rows.push_back({ unbroken(load_title(row, "≤")) });
        table.rows[i].insert(table.rows[i].end(), { spin_cell(row), in_percent(row.difference) });
        ++i;
      }
  }
  return table;
}

ReportSection table_section(const Comparison &comparison)
{
  ReportSection section = {
    "All rows",
    "m is the moment ratio |M_N| / (N R / 2). The least load is that of the harmonics kept, the rim that "
    "carries that of the contact itself, both at the terminal spin."
  };
  for (const ring::Closure closure : compared_closures)
    section.tables.push_back(closure_table(comparison, closure));
  for (const ComparisonRow &row : comparison.rows)
    if (!row.trouble.empty())
      section.text += "\n\n" + row.load + ", closure " + ring::to_string(row.closure) + ", harmonics " +
                      harmonics_name(row) + ": " + row.trouble + ".";
  return section;
}

ReportSection overview_section(const Comparison &comparison)
{
  return {
    "Harmonics beside closures",
    "Closure paper balances the centripetal part of the hand's force alone, hand the whole force of the "
    "hand, full also the moment of the friction about the centre of mass. All loads are in balance with "
    "the friction that they cause, at every spin, but for that of the elastic foot at rest. A rigid "
    "rim's first harmonic is the first harmonic itself, whatever it stands on. Formal: the load, or "
    "what is left of it, would have to pull on the table.",
    { spin_figure(comparison) },
    { overview_table(comparison) }
  };
}

} // namespace

Report comparison_report(const Study &study, const Comparison &comparison)
{
  Report report = { "What changes the spin of a wine glass", comparison_answer(comparison), {} };
  report.sections = { overview_section(comparison), table_section(comparison) };
  for (const ReportSection &section : study_sections(study))
    report.sections.push_back(section);
  ReportSection files = { "Files" };
  files.files = { { "compare.csv", "all rows" },
                  { "summary.json", "all numbers, for programs" },
                  { "parameters.prm", "the study, to be run again" },
                  { "timings.json", "how long it took" } };
  report.sections.push_back(files);
  return report;
}

} // namespace stemware::pipeline
