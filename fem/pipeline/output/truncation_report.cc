#include "fem/pipeline/output/truncation_report.h"

#include "fem/pipeline/analysis/paper_spin_up.h"
#include "fem/pipeline/output/harmonics_table.h"
#include "fem/pipeline/output/render/plots.h"
#include "fem/pipeline/output/study_sections.h"
#include "fem/pipeline/output/truncation_tables.h"
#include "fem/pipeline/support/text_layout.h"

#include <algorithm>
#include <cmath>

namespace stemware::pipeline
{

namespace
{

/// Differences below this share of the spin are torque_rounding; a logarithmic axis should not show them.
constexpr double torque_rounding = 1e-13;

Curve change_curve(const std::string &title, const TruncationTable &table)
{
  Curve curve = { title, {}, {}, CurveStyle::line_and_points };
  for (const TruncatedAnswer &answer : table.answers)
    if (answer.relative_change && std::abs(*answer.relative_change) > torque_rounding)
    {
      curve.x.push_back(answer.harmonics);
      curve.y.push_back(std::abs(*answer.relative_change));
    }
  return curve;
}

/// What the a-priori bound on the torque says about the spin, to first order: bound / |d tau / d omega|.
Curve bound_curve(const TruncationTable &table, double slope)
{
  Curve curve = { "a-priori bound, to first order", {}, {}, CurveStyle::line };
  const double spin = std::abs(*table.all().omega_terminal);
  for (const TruncatedAnswer &answer : table.answers)
    if (answer.bound && *answer.bound / (slope * spin) > torque_rounding)
    {
      curve.x.push_back(answer.harmonics);
      curve.y.push_back(*answer.bound / (slope * spin));
    }
  return curve;
}

ReportFigure change_figure(const TruncationStudy &result)
{
  CurvePlot plot;
  plot.name = "terminal_spin";
  plot.caption = "What is missing in the terminal spin when the load is cut off, relative to all harmonics.";
  plot.x = { "harmonics kept" };
  plot.y = { "|change of terminal spin|", true };
  plot.curves = { change_curve("cut off, nothing answers", result.frozen) };
  if (result.self_consistent && result.acts_back)
    plot.curves.push_back(change_curve("in balance with its own friction", *result.self_consistent));
  plot.curves.push_back(bound_curve(result.frozen, std::abs(result.torque_slope)));
  return curve_figure(plot);
}

ReportFigure deviation_figure(const std::string &name, const std::string &how, const TruncationStudy &result,
                              const TruncationTable &table)
{
  CurvePlot plot;
  plot.name = name;
  plot.caption = "How far ω(t) is from that of all harmonics, " + how + ".";
  plot.x = { "t (s)" };
  plot.y = { "|ω_n - ω_all| (rad/s)", true };
  const TruncatedAnswer &all = table.all();
  for (const TruncatedAnswer &answer : table.answers)
  {
    Curve curve = { truncation_title(answer.harmonics, all.harmonics), {}, {} };
    curve.line_type = static_cast<unsigned int>(plot.curves.size()) + 2; // all harmonics have the first
    for (std::size_t i = 1; i < answer.spin_up.size(); ++i)
      if (const double deviation = std::abs(answer.spin_up[i] - all.spin_up[i]);
          deviation > 1e-10 * std::abs(*all.omega_terminal))
      {
        curve.x.push_back(result.time[i]);
        curve.y.push_back(deviation);
      }
    if (!curve.x.empty() && plot.curves.size() < 6)
      plot.curves.push_back(curve);
  }
  return curve_figure(plot);
}

/// What the load does to the spin.
ReportTable spin_table(const std::string &caption, const TruncationTable &table)
{
  ReportTable report = { caption,
                         { "harmonics", "amplitude of the last / a_0", "terminal spin (rad/s)",
                           "change of spin", "ω(t) off by (rad/s)", "at the end (rad/s)",
                           "bound on Δτ_z (N\u00a0m)" },
                         {} };
  for (const TruncatedAnswer &answer : table.answers)
    report.rows.push_back({ std::to_string(answer.harmonics), formatted("%.3e", answer.amplitude),
                            formatted_or("–", "%.8g", answer.omega_terminal), shown_change(answer),
                            shown_deviation(table, answer.largest_deviation),
                            shown_deviation(table, answer.final_deviation), shown_bound(answer) });
  return report;
}

/// The load itself, and its torque.
ReportTable torque_table(const std::string &caption, const TruncationStudy &result,
                         const TruncationTable &table)
{
  ReportTable report = { caption, { "harmonics", "τ_z at rest (N\u00a0m)" }, {} };
  for (const double omega : result.omega)
    report.header.push_back(formatted("τ_z at %.6g rad/s (N\u00a0m)", omega));
  report.header.insert(report.header.end(),
                       { "least load (N/rad)", "would have to pull (of N)", "m at the terminal spin" });
  for (const TruncatedAnswer &answer : table.answers)
  {
    std::vector<std::string> &row = report.rows.emplace_back();
    row = { std::to_string(answer.harmonics), shown_torque(table, answer.tau_at_rest) };
    for (const double torque : answer.torque)
      row.push_back(shown_torque(table, torque));
    const NegativeLoad worst = answer.worst();
    row.insert(row.end(), { formatted("%.4g", worst.minimum),
                            answer.pulls() ? formatted("%.3g %%", 100 * worst.pulling_share) : "–",
                            answer.load ? formatted("%.5g", answer.load->moment_ratio()) : "–" });
  }
  return report;
}

/// Terminal spins as torque_figure() takes them.
std::vector<TruncationRow> terminal_points(const TruncationTable &table)
{
  std::vector<TruncationRow> rows;
  for (const TruncatedAnswer &answer : table.answers)
    if (answer.omega_terminal)
    {
      rows.emplace_back();
      rows.back().harmonics = answer.harmonics;
      rows.back().omega_terminal = *answer.omega_terminal;
    }
  return rows;
}

/// Spin-ups with 1, 2, 3 and all harmonics, in the colours of torque_figure(), and the paper's.
std::vector<SpinUp> shown_spin_ups(const Study &study, const TruncationTable &table)
{
  const unsigned int n_all = table.all().harmonics;
  std::vector<SpinUp> curves = { { truncation_title(n_all, n_all), table.all().spin_up, 1 } };
  for (const TruncatedAnswer &answer : table.answers)
    if (answer.harmonics <= 3 && answer.harmonics < n_all && !answer.spin_up.empty())
      curves.push_back({ truncation_title(answer.harmonics, n_all), answer.spin_up, answer.harmonics + 1 });
  curves.push_back({ "the paper's model", paper_spin_up(study) });
  curves.back().line_type = 7;
  return curves;
}

/// Sentences about answers that do not exist.
std::string troubles(const TruncationTable &table)
{
  std::string text;
  for (const TruncatedAnswer &answer : table.answers)
    if (!answer.trouble.empty())
      text += formatted("\n\nWith %u harmonics: ", answer.harmonics) + answer.trouble + ".";
  return text;
}

/// Everything about one way of leaving harmonics out; @p suffix makes the names of its figures its own.
ReportSection table_section(const std::string &heading, const std::string &text, const std::string &suffix,
                            const Study &study, const TruncationStudy &result, const TruncationTable &table)
{
  const std::string how = suffix.empty() ? "the load cut off" : "in balance with its own friction";
  ReportSection section = { heading, text + troubles(table) };
  section.figures = { torque_figure(table.torque, terminal_points(table), "torque" + suffix),
                      spin_up_figure(result.time, shown_spin_ups(study, table), "spin_up" + suffix) };
  section.figures[1].caption = "Spin-up from rest, n harmonics kept, beside the paper's result.";
  if (table.answers.size() > 1)
    section.figures.push_back(deviation_figure("deviation" + suffix, how, result, table));
  const std::string name = suffix.empty() ? "Frozen" : "Self-consistent";
  section.tables = { spin_table(name + ": the spin", table),
                     torque_table(name + ": torque and load, the worse of rest and terminal spin", result,
                                  table) };
  return section;
}

ReportSection frozen_section(const Study &study, const TruncationStudy &result)
{
  const std::string load = result.same_whole_load
                             ? "The load of all harmonics loses some of them at every spin. "
                             : "The load at rest, kept at every spin, loses some of its harmonics. ";
  return table_section(
    "Cut off, nothing answers (frozen)",
    load + "The torque at rest, μ M_Nx, stays: it lies in the first harmonic. The bound is known before "
           "anything is solved: μ R Σ |K_n(ε)| √(a_n² + b_n²) over what "
           "is left out, at the terminal spin of all harmonics. A load that is negative somewhere would have "
           "to pull on the table; all harmonics of a foot that lifts off still leave a little of that, where "
           "their series overshoots.",
    "", study, result, result.frozen);
}

ReportSection balance_section(const Study &study, const TruncationStudy &result)
{
  const std::string heading = "In balance with its own friction (self-consistent)";
  if (!result.self_consistent)
    return { heading, result.why_not };
  if (!result.acts_back)
    return { heading, "The closure lets no friction act back on the load: cutting it off changes nothing in "
                      "the balance of moments, and the tables above are these too." };
  return table_section(
    heading,
    "The friction T of the load that is left enters the moment M_N that the table has to answer, M_N "
    "the contact, and the contact's load is cut off again, at every spin. The first harmonic alone is the "
    "formal first harmonic on a ring of the contact's radius.",
    "_self_consistent", study, result, *result.self_consistent);
}

std::vector<LoadSample> samples_of(const RingLoad &load)
{
  std::vector<LoadSample> samples;
  for (const fem::AzimuthLoad &place : load.pointwise)
    samples.push_back({ place.azimuth, place.density });
  std::sort(samples.begin(), samples.end(),
            [](const LoadSample &one, const LoadSample &other) { return one.theta < other.theta; });
  return samples;
}

ReportSection load_section(const RingLoad &load)
{
  return { "The load at rest",
           formatted("Moment ratio %.5g; a ring of radius %.6g m stands for the foot. %.1f %% of the rim "
                     "carries load.",
                     load.moment_ratio, load.at_rest.radius(), 100 * load.contact_fraction),
           { load_figure(load.at_rest, samples_of(load)), spectrum_figure(load.at_rest) },
           { harmonics_table(load.at_rest) } };
}

ReportSection file_section(const TruncationStudy &result)
{
  ReportSection section = { "Files" };
  section.files = { { "summary.json", "all numbers, for programs" },
                    { "parameters.prm", "the study, to be run again" },
                    { "harmonics.dat", "Fourier coefficients of the load at rest; Load/File reads them" },
                    { "truncation.dat", "the answer by the number of harmonics, frozen" },
                    { "spin_up.dat", "the spin against time by the number of harmonics, frozen" } };
  if (result.self_consistent)
  {
    section.files.push_back({ "truncation_self_consistent.dat", "the same, self-consistent" });
    section.files.push_back({ "spin_up_self_consistent.dat", "the same, self-consistent" });
  }
  section.files.push_back({ "timings.json", "how long it took" });
  return section;
}

} // namespace

Report truncation_report(const Study &study, const StudyLoad &load, const TruncationStudy &result)
{
  Report report = { "How many harmonics of the load matter", truncation_answer(study, result), {} };
  if (result.frozen.all().relative_change && result.frozen.answers.size() > 1)
    report.sections.push_back(
      { "The terminal spin by the number of harmonics", "", { change_figure(result) } });
  report.sections.insert(report.sections.end(), { load_section(load.load), frozen_section(study, result),
                                                  balance_section(study, result) });
  for (const ReportSection &section : study_sections(study))
    report.sections.push_back(section);
  report.sections.push_back(file_section(result));
  return report;
}

} // namespace stemware::pipeline
