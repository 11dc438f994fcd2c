#include "fem/pipeline/output/truncation_results.h"

#include "fem/pipeline/output/answer.h"
#include "fem/pipeline/output/common_sections.h"
#include "fem/pipeline/output/plots/plots.h"
#include "fem/pipeline/output/quantities.h"
#include "fem/pipeline/output/render/table_renderers.h"
#include "fem/pipeline/output/run_tables.h"
#include "fem/pipeline/output/spin_table.h"

namespace stemware::pipeline
{

namespace
{

using Json = nlohmann::ordered_json;

/// One of the two ways of leaving harmonics out.
struct Way
{
  const TruncationTable &table;
  std::string heading, how, name;
  std::string suffix; ///< of its files and plots
};

/// Afterwards, and in the loop where there is a balance.
std::vector<Way> ways_of(const TruncationStudy &study)
{
  std::vector<Way> ways = { { study.frozen, "Truncated afterwards (moment unchanged)", "truncated afterwards",
                              "Afterwards", "" } };
  if (study.self_consistent)
    ways.push_back({ *study.self_consistent, "Truncated in the loop (moment recomputed)",
                     "truncated in the loop", "In the loop", "_self_consistent" });
  return ways;
}

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
  "harmonics amplitude omega_terminal relative_change spin_up_deviation bound "
  "tau_at_rest torque[] least_load pulls_with";
constexpr char spin_columns[] = "harmonics amplitude omega_terminal relative_change spin_up_deviation "
                                "spin_up_deviation_at_end bound";
constexpr char load_columns[] =
  "harmonics tau_at_rest torque[] least_load pulls_with moment_ratio_at_terminal";

/// All numbers of one way of truncating by the number of harmonics.
Table truncation_table(const TruncationTable &truncations, const std::vector<double> &omega)
{
  Table table = spin_table(truncations.rows, omega);
  table["tau_at_rest"].digits = format::significant<6>;
  table["tau_at_rest"].label = "tau at 0";
  table["bound"].name += " of all harmonics";
  table["bound"].console_digits = nullptr;
  table["message"].key = "trouble";
  return table;
}

/// omega(t) by the number of harmonics; truncations without a spin-up are left out.
Table spin_up_table(const std::vector<double> &time, const TruncationTable &truncations)
{
  Table table = { "Spin-up from rest", { column(quantity::time, time) } };
  for (const SpinRow &row : truncations.rows)
    if (!row.spin_up.empty())
      table.columns.push_back(
        numbers("omega, harmonics up to " + std::to_string(row.harmonics), "rad/s", row.spin_up));
  return table;
}

Findings findings_of(const LoadReport &load, const TruncationStudy &study)
{
  const bool balanced = study.self_consistent.has_value();
  const TruncationTable &best = balanced ? *study.self_consistent : study.frozen;
  const auto change_of_first = [](const TruncationTable &table)
  { return json_number(table.rows.front().relative_change); };
  const auto rows_of = [&](const TruncationTable &table)
  { return json_table(truncation_table(table, study.omega).with("", json_columns)); };
  Findings findings;
  findings.summary = { { "load", load_summary(load) },
                       { "torque_at", study.omega },
                       { "truncation", rows_of(study.frozen) },
                       { "truncation_self_consistent",
                         balanced ? rows_of(*study.self_consistent) : Json(nullptr) },
                       { "why_not_self_consistent", balanced ? Json(nullptr) : Json(study.why_not) } };
  findings.key_figures = {
    { "omega_terminal", json_number(best.all().omega_terminal()) },
    { "omega_terminal_band",
      study.same_whole_load || !balanced ? json_number(study.frozen.all().band) : Json(nullptr) },
    { "relative_change_first_harmonic", change_of_first(study.frozen) },
    { "relative_change_first_harmonic_self_consistent",
      balanced ? change_of_first(*study.self_consistent) : Json(nullptr) },
    { "closure_effect", json_number(relative_effect(row_of(study.closures, ring::Closure::paper),
                                                    row_of(study.closures, ring::Closure::full))) },
    { "harmonics_for_1e-4", harmonics_enough(best, 1e-4) }
  };
  return findings;
}

// ---- report

/// Spin-ups with 1, 2, 3 and all harmonics, in the colours of torque_plot(), and the paper's.
std::vector<Curve> shown_spin_ups(const TruncationStudy &study, const TruncationTable &table)
{
  const auto curve = [&](const std::string &title, const std::vector<double> &omega, unsigned int line_type)
  { return Curve{ title, study.time, omega, CurveStyle::line, {}, line_type }; };
  const unsigned int n_all = table.all().harmonics;
  std::vector<Curve> curves = { curve(truncation_title(n_all, n_all), table.all().spin_up, 1) };
  for (const SpinRow &row : table.rows)
    if (row.harmonics <= 3 && row.harmonics < n_all && !row.spin_up.empty())
      curves.push_back(curve(truncation_title(row.harmonics, n_all), row.spin_up, row.harmonics + 1));
  curves.push_back(curve("the paper's model", study.paper, 7));
  return curves;
}

/// Sentences about rows that lack something.
std::string reasons(const TruncationTable &table)
{
  std::string text;
  for (const SpinRow &row : table.rows)
    if (!row.reason.empty())
      text += fmt::format(FMT_STRING("\n\nWith {} harmonics: {}."), row.harmonics, row.reason);
  return text;
}

/// Everything about one way of truncating.
ReportSection table_section(const std::string &text, const TruncationStudy &study, const Way &way)
{
  ReportSection section = { way.heading, text + reasons(way.table) };
  section.plots = { torque_plot(way.table.torque, way.table.rows, "torque" + way.suffix),
                    spin_up_plot(shown_spin_ups(study, way.table), "spin_up" + way.suffix,
                                 "Spin-up from rest, n harmonics kept, beside the paper's result.") };
  if (way.table.rows.size() > 1)
    section.plots.push_back(deviation_plot("deviation" + way.suffix, way.how, study.time, way.table));
  const Table table = truncation_table(way.table, study.omega);
  section.tables = { table.with(way.name + ": the spin", spin_columns),
                     table.with(way.name + ": torque and load, the worse of rest and terminal spin",
                                load_columns) };
  return section;
}

ReportSection frozen_section(const TruncationStudy &study)
{
  return table_section(
    std::string(study.same_whole_load
                  ? "The load of all harmonics loses some of them at every spin. "
                  : "The load at rest, kept at every spin, loses some of its harmonics. ") +
      "The torque at rest, μ M_Nx, stays: it lies in the first harmonic. The bound is known before anything "
      "is solved: μ R Σ |K_n(ε)| √(a_n² + b_n²) over what is left out, at the terminal spin of all "
      "harmonics. A load that is negative somewhere would have to pull on the table; all harmonics of a foot "
      "that lifts off still leave a little of that, where their series overshoots.",
    study, ways_of(study).front());
}

ReportSection balance_section(const TruncationStudy &study)
{
  if (!study.self_consistent)
    return { "Truncated in the loop (moment recomputed)", study.why_not };
  const Way way = ways_of(study).back();
  if (!study.acts_back)
    return { way.heading, "In this moment balance friction does not act back on the load: truncation changes "
                          "nothing in the balance, and the tables above are these too." };
  return table_section(
    "The friction T of the truncated load enters the moment M_N that the table has to provide, M_N the "
    "contact, and the contact's load is truncated again, at every spin. The first harmonic alone is the "
    "formal first harmonic on a ring of the contact's radius.",
    study, way);
}

ReportSection load_section(const LoadReport &load)
{
  return { "The load at rest",
           fmt::format(
             FMT_STRING("Moment ratio {:.5g}; the equivalent ring has a radius of {:.6g} m. {:.1f} % of the "
                        "rim carries load."),
             load.moment_ratio, load.rings.radius(), 100 * load.contact_fraction),
           { load_plot(load.rings, load.pointwise), spectrum_plot(load.rings) },
           { harmonics_table(load.rings) } };
}

std::vector<ResultFile> files_of(const LoadReport &load, const TruncationStudy &study)
{
  std::vector<ResultFile> files = { { "summary.json", "all numbers, for programs" },
                                    { "parameters.prm", "the study, to be run again" },
                                    { "harmonics.dat",
                                      "Fourier coefficients of the load at rest; Load/File reads them",
                                      load_file_text(load.rings) } };
  for (const Way &way : ways_of(study))
  {
    files.push_back(
      { "truncation" + way.suffix + ".dat", "the answer by the number of harmonics, " + way.how,
        truncation_table(way.table, study.omega)
          .with("The answer with the load cut off after some harmonics; nan: there is none", data_columns) });
    files.push_back({ "spin_up" + way.suffix + ".dat",
                      "the spin against time by the number of harmonics, " + way.how,
                      spin_up_table(study.time, way.table) });
  }
  files.push_back({ "timings.json", "how long it took" });
  return files;
}

std::vector<ConsoleBlock> console_of(const std::string &answer, const TruncationStudy &study)
{
  std::vector<ConsoleBlock> blocks = { { answer } };
  for (const Way &way : ways_of(study))
    if (way.suffix.empty() || study.acts_back)
      blocks.push_back(
        { way.heading + ":", truncation_table(way.table, study.omega).with("", console_columns) });
  if (!study.self_consistent)
    blocks.push_back({ study.why_not });
  return blocks;
}

} // namespace

Results tabulate(const Study &study, const LoadReport &load, const TruncationStudy &truncations)
{
  Results results;
  results.files = files_of(load, truncations);
  Report &report = results.report;
  report = { "How many harmonics of the load matter", truncation_answer(truncations), {} };
  if (truncations.frozen.all().relative_change && truncations.frozen.rows.size() > 1)
    report.sections.push_back(
      { "The terminal spin by the number of harmonics", "", { truncation_plot(truncations) } });
  report.sections.insert(report.sections.end(),
                         { load_section(load), frozen_section(truncations), balance_section(truncations) });
  add_closing_sections(report, study, results.files);
  results.console = console_of(report.answer, truncations);
  results.findings = findings_of(load, truncations);
  return results;
}

} // namespace stemware::pipeline
