#include "fem/pipeline/report/truncation_results.h"

#include "fem/pipeline/report/answer.h"
#include "fem/pipeline/report/budget_tables.h"
#include "fem/pipeline/report/common_sections.h"
#include "fem/pipeline/report/plots/plots.h"
#include "fem/pipeline/report/quantities.h"
#include "fem/pipeline/report/render/table_renderers.h"
#include "fem/pipeline/report/run_tables.h"
#include "fem/pipeline/report/spin_table.h"

#include <algorithm>
#include <cmath>

namespace stemware::pipeline
{

namespace
{

using Json = nlohmann::ordered_json;

constexpr char json_columns[] = "harmonics amplitude tau_at_rest torque[] omega_terminal relative_change "
                                "spin_up_deviation spin_up_deviation_at_end bound pulls load_minimum "
                                "pulling_share load_minimum_at_terminal pulling_share_at_terminal "
                                "load_at_terminal trouble";
constexpr char data_columns[] =
  "harmonics amplitude tau_at_rest omega_terminal relative_change "
  "spin_up_deviation spin_up_deviation_at_end bound ring_radius_at_terminal "
  "moment_ratio_at_terminal load_minimum load_minimum_at_terminal pulling_share "
  "pulling_share_at_terminal pulls torque[]";
constexpr char console_columns[] =
  "harmonics amplitude omega_terminal relative_change spin_up_deviation bound least_load";
constexpr char spin_columns[] = "harmonics amplitude omega_terminal relative_change spin_up_deviation "
                                "spin_up_deviation_at_end bound";
constexpr char load_columns[] =
  "harmonics tau_at_rest torque[] least_load pulls_with moment_ratio_at_terminal";

/// All numbers of @p rows by the number of harmonics.
Table truncation_table(const TruncationStudy &study, const std::vector<SpinRow> &rows)
{
  Table table = spin_table(rows, study.omega);
  table["tau_at_rest"].digits = format::significant<6>;
  table["tau_at_rest"].label = "tau at 0";
  table["bound"].name += " of all harmonics";
  table["bound"].console_digits = nullptr;
  table["message"].key = "trouble";
  return table;
}

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
  Table table = { "Spin-up from rest", { column(quantity::time, study.time) } };
  for (const SpinRow &row : study.rows)
    if (!row.spin_up.empty())
      table.columns.push_back(
        numbers("omega, harmonics up to " + std::to_string(row.harmonics), "rad/s", row.spin_up));
  return table;
}

Findings findings_of(const LoadReport &load, const TruncationStudy &study, const Json &budget)
{
  Findings findings;
  findings.summary = { { "load", load_summary(load) },
                       { "torque_at", study.omega },
                       { "harmonic_effect", harmonic_effect_summary(study.harmonics) },
                       { "budget", budget },
                       { "truncation",
                         json_table(truncation_table(study, study.rows).with("", json_columns)) } };
  findings.key_figures = { { "omega_terminal", json_number(study.all().omega_terminal()) },
                           { "omega_terminal_band", json_number(study.all().band) },
                           { "harmonic_effect", json_number(study.harmonics.absolute) },
                           { "harmonic_effect_relative", json_number(study.harmonics.relative) },
                           { "harmonics_for_1e-4", harmonics_enough(study.rows, 1e-4) } };
  return findings;
}

// ---- report

/// Spin-ups with 1, 2, 3 and all harmonics, in the colours of torque_plot(), and the paper's.
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

/// truncation.dat.
Table truncation_file(const TruncationStudy &study)
{
  return truncation_table(study, study.rows)
    .with("The answer with the load cut off after some harmonics; nan: there is none", data_columns);
}

/// Sentences about rows that lack something.
std::string reasons(const TruncationStudy &study)
{
  std::string text;
  for (const SpinRow &row : study.rows)
    if (!row.reason.empty())
      text += fmt::format(FMT_STRING("\n\nWith {} harmonics: {}."), row.harmonics, row.reason);
  return text;
}

/// What happens to the load where harmonics are left out.
std::string how_truncated(const Study &study)
{
  if (is_one_way(study))
    return "One-way: the load of rest, kept at every spin, loses some of its harmonics; neither contact nor "
           "friction is solved again.";
  return "In balance at every spin: the friction of the harmonics that are kept enters the moment that the "
         "table has to provide, and that moment the contact, which has its whole pressure.";
}

ReportSection table_section(const Study &study, const TruncationStudy &truncations)
{
  const Table table = truncation_table(truncations, truncations.rows);
  ReportSection section = {
    "Fewer harmonics",
    how_truncated(study) +
      " The torque at rest, μ M_Nx, stays: it lies in the first harmonic. The bound is known before anything "
      "is solved: μ Σ r |K_n(ε)| √(a_n² + b_n²) over the rings and what is left out, at the terminal spin of "
      "all harmonics. A load that is negative somewhere would have to pull on the table; all harmonics of a "
      "foot that lifts off still leave a little of that, where their series overshoots." +
      reasons(truncations),
    { torque_plot(truncations.torque, truncations.rows),
      spin_up_plot(truncations.time, shown_spin_ups(truncations), truncations.all(),
                   "Spin-up from rest, n harmonics kept, beside the paper's result.") },
    { table.with("The spin", spin_columns),
      table.with("Torque and load, the worse of rest and terminal spin", load_columns) }
  };
  if (truncations.rows.size() > 1)
    section.plots.push_back(deviation_plot(truncations.rows));
  return section;
}

ReportSection load_section(const LoadReport &load, ring::OrbitSense sense, const ErrorBands &bands)
{
  const std::vector<double> band = spectrum_band(bands, load.rings.n_harmonics());
  return { "The load at rest",
           fmt::format(
             FMT_STRING("Moment ratio {:.5g}; the equivalent ring has a radius of {:.6g} m. {:.1f} % of the "
                        "rim carries load."),
             format::Number{ load.moment_ratio }, format::Number{ load.rings.radius() },
             format::Number{ 100 * load.contact_fraction }),
           { load_plot(load.rings, drawn_pointwise(load), sense), spectrum_plot(load.rings, band) },
           { harmonics_table(load.rings, band) } };
}

std::vector<ResultFile> files_of(const LoadReport &load, const TruncationStudy &study)
{
  return { { "summary.json", "all numbers, for programs" },
           { "parameters.prm", "the study, to be run again" },
           { "harmonics.dat", "Fourier coefficients of the load at rest; Load/File reads them",
             load_file_text(load.rings) },
           { "rings.dat", "the same ring by ring", ring_table(load.rings) },
           { "truncation.dat", "the answer by the number of harmonics", truncation_file(study) },
           { "torque.dat", "τ_z, T_x, T_y against the spin, of 1, 2, 3 and all harmonics",
             torque_table(study.torque) },
           { "spin_up.dat", "the spin against time by the number of harmonics", spin_up_table(study) },
           { "timings.json", "how long it took" } };
}

} // namespace

Results tabulate(const Study &study, const LoadReport &load, const TruncationStudy &truncations,
                 const ErrorBands &bands)
{
  Results results;
  results.files = files_of(load, truncations);
  Report &report = results.report;
  const Budget budget = chain_alone(truncations.budget);
  report = { "How many harmonics of the load matter", truncation_answer(study, truncations), {} };
  if (truncations.all().relative_change && truncations.rows.size() > 1)
    report.sections.push_back({ "The terminal spin by the number of harmonics",
                                "",
                                { truncation_plot(truncations, truncation_file(truncations)) } });
  report.sections.insert(report.sections.end(), { chain_section(study, budget),
                                                  load_section(load, study.motion.orbit.orbit_sense, bands),
                                                  table_section(study, truncations) });
  if (is_one_way(study))
    say_one_way(report);
  add_closing_sections(report, study, results.files);
  Budget steps = budget;
  steps.rows = named_steps(budget.rows);
  results.console = {
    { report.answer },
    { is_one_way(study) ? "One-way, the load of rest cut off:" : "In balance at every spin:",
      truncation_table(truncations, rows_that_differ(truncations)).with("", console_columns) },
    chain_block(study, steps)
  };
  results.findings = findings_of(load, truncations, budget_summary(study, budget));
  return results;
}

} // namespace stemware::pipeline
