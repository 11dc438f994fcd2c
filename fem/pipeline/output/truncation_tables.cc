#include "fem/pipeline/output/truncation_tables.h"

#include "fem/pipeline/output/answer.h"
#include "fem/pipeline/output/summary.h"
#include "fem/pipeline/support/text_file.h"
#include "fem/pipeline/support/text_layout.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>

namespace stemware::pipeline
{

using Json = nlohmann::ordered_json;

namespace
{

/// A column of one figure of each answer.
template <typename Figure>
DataColumn column(const std::string &name, const std::string &unit, const TruncationTable &table,
                  Figure figure)
{
  DataColumn result = { name, unit, {} };
  for (const TruncatedAnswer &answer : table.answers)
    result.values.push_back(static_cast<double>(figure(answer)));
  return result;
}

/// The same of a figure that may be missing.
DataColumn column(const std::string &name, const std::string &unit, const TruncationTable &table,
                  std::optional<double> TruncatedAnswer::*figure)
{
  return column(name, unit, table,
                [=](const TruncatedAnswer &answer)
                { return (answer.*figure).value_or(std::numeric_limits<double>::quiet_NaN()); });
}

Json finite_or_null(double value)
{
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

/// The coefficients of a load, or null.
Json series_summary(const std::optional<ring::RingStack> &load)
{
  if (!load)
    return nullptr;
  Json a = Json::array(), b = Json::array();
  for (unsigned int n = 0; n <= load->n_harmonics(); ++n)
  {
    a.push_back(load->a(n));
    b.push_back(load->b(n));
  }
  return {
    { "a", a }, { "b", b }, { "ring_radius", load->radius() }, { "moment_ratio", load->moment_ratio() }
  };
}

Json row_summary(const TruncatedAnswer &answer)
{
  Json torque = Json::array();
  for (const double value : answer.torque)
    torque.push_back(finite_or_null(value));
  const auto &terminal = answer.at_terminal;
  return { { "harmonics", answer.harmonics },
           { "amplitude", answer.amplitude },
           { "tau_at_rest", answer.tau_at_rest },
           { "torque", torque },
           { "omega_terminal", number_or_null(answer.omega_terminal) },
           { "relative_change", number_or_null(answer.relative_change) },
           { "spin_up_deviation", number_or_null(answer.largest_deviation) },
           { "spin_up_deviation_at_end", number_or_null(answer.final_deviation) },
           { "bound", number_or_null(answer.bound) },
           { "pulls", answer.pulls() },
           { "load_minimum", answer.at_rest.minimum },
           { "pulling_share", answer.at_rest.pulling_share },
           { "load_minimum_at_terminal", terminal ? Json(terminal->minimum) : Json(nullptr) },
           { "pulling_share_at_terminal", terminal ? Json(terminal->pulling_share) : Json(nullptr) },
           { "load_at_terminal", series_summary(answer.load) },
           { "trouble", answer.trouble.empty() ? Json(nullptr) : Json(answer.trouble) } };
}

Json table_summary(const TruncationTable &table)
{
  Json rows = Json::array();
  for (const TruncatedAnswer &answer : table.answers)
    rows.push_back(row_summary(answer));
  return rows;
}

std::string table_text(const std::vector<double> &omega, const TruncationTable &table)
{
  TextColumn harmonics = { "harmonics", {} }, amplitude = { "last one\nover a_0", {} },
             spin = { "terminal spin\n(rad/s)", {} }, change = { "change\nof spin", {} },
             deviation = { "omega(t) off by\n(rad/s)", {} }, bound = { "bound on torque\n(N m)", {} },
             at_rest = { "tau at 0\n(N m)", {} }, least = { "least load\n(N/rad)", {} },
             pull = { "pulls with\n(of N)", {} };
  std::vector<TextColumn> torques;
  for (const double chosen : omega)
    torques.push_back({ formatted("tau at %.4g\n(N m)", chosen), {} });
  for (const TruncatedAnswer &answer : table.answers)
  {
    const NegativeLoad worst = answer.worst();
    harmonics.cells.push_back(std::to_string(answer.harmonics));
    amplitude.cells.push_back(formatted("%.2e", answer.amplitude));
    spin.cells.push_back(formatted_or("-", "%.8g", answer.omega_terminal));
    change.cells.push_back(shown_change(answer));
    deviation.cells.push_back(shown_deviation(table, answer.largest_deviation));
    bound.cells.push_back(shown_bound(answer));
    at_rest.cells.push_back(shown_torque(table, answer.tau_at_rest));
    least.cells.push_back(formatted("%.4g", worst.minimum));
    pull.cells.push_back(answer.pulls() ? formatted("%.2g %%", 100 * worst.pulling_share) : "-");
    for (std::size_t i = 0; i < torques.size(); ++i)
      torques[i].cells.push_back(shown_torque(table, answer.torque[i]));
  }
  std::vector<TextColumn> columns = { harmonics, amplitude, spin, change, deviation, bound, at_rest };
  columns.insert(columns.end(), torques.begin(), torques.end());
  columns.insert(columns.end(), { least, pull });
  return text_table(columns);
}

/// "With the first harmonic of its load alone the glass spins up to A rad/s, with all 24 to B rad/s
/// (harmonics: C %)", without a full stop; B with its error band @p band where one is known.
std::string effect_of_harmonics(const TruncationTable &table, const std::optional<double> &band = {})
{
  const TruncatedAnswer &first = table.answers.front(), &all = table.all();
  const std::string both =
    formatted("with all %u to ", all.harmonics) + with_band(*all.omega_terminal, band) + " rad/s";
  if (!first.omega_terminal)
    return "with the first harmonic of its load alone the glass has no terminal spin, " + both;
  return formatted("with the first harmonic of its load alone the glass spins up to %.6g rad/s, ",
                   *first.omega_terminal) +
         both + " (harmonics: " + in_percent(*all.omega_terminal / *first.omega_terminal - 1) + ")";
}

std::string capitalised(std::string sentence)
{
  sentence[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(sentence[0])));
  return sentence;
}

/// The same where the load of rest is kept at every spin.
std::string load_at_rest_sentence(const TruncationTable &table)
{
  const TruncatedAnswer &first = table.answers.front(), &all = table.all();
  std::string text =
    formatted("With the load at rest kept at every spin it would be %.6g rad/s", *all.omega_terminal);
  if (first.omega_terminal)
    text += formatted(", and %.6g with the first harmonic alone (harmonics: %s)", *first.omega_terminal,
                      in_percent(*all.omega_terminal / *first.omega_terminal - 1).c_str());
  return text + ".";
}

/// The harmonics' part of the answer: in balance where there is a balance, and what the study's own load says
/// where that is another.
std::string harmonic_sentences(const TruncationStudy &result)
{
  const TruncatedAnswer &all = result.frozen.all();
  if (!all.relative_change)
    return "The glass does not spin up, whatever harmonics its load has.";
  if (all.harmonics == 1)
    return formatted("The load has one harmonic; the terminal spin is %.6g rad/s.", *all.omega_terminal);
  if (!result.self_consistent || !result.acts_back)
    return capitalised(effect_of_harmonics(result.frozen, result.spin_band)) + ".";
  if (!result.same_whole_load)
    return capitalised(effect_of_harmonics(*result.self_consistent)) +
           ", contact and friction in balance at every spin. " + load_at_rest_sentence(result.frozen);
  std::string text = capitalised(effect_of_harmonics(*result.self_consistent, result.spin_band)) + ".";
  if (const auto &cut = result.frozen.answers.front().omega_terminal)
    text +=
      formatted(" (Cut off without an answer of contact and friction, the first leaves %.6g rad/s.)", *cut);
  return text;
}

/// The table that the answer is about.
const TruncationTable &main_table(const TruncationStudy &result)
{
  return result.self_consistent ? *result.self_consistent : result.frozen;
}

/// Differences of spin that are rounding, relative to the spin.
constexpr double spin_rounding = 1e-11;

} // namespace

std::string truncation_data(const TruncationStudy &study, const TruncationTable &table)
{
  using Answer = TruncatedAnswer;
  constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
  std::vector<DataColumn> columns = {
    column("harmonics", "1", table, [](const Answer &answer) { return answer.harmonics; }),
    column("amplitude of the highest one over a_0 at rest", "1", table,
           [](const Answer &answer) { return answer.amplitude; }),
    column("tau_z at rest", "N m", table, [](const Answer &answer) { return answer.tau_at_rest; }),
    column("terminal omega", "rad/s", table, &Answer::omega_terminal),
    column("relative change of terminal omega to all harmonics", "1", table, &Answer::relative_change),
    column("largest deviation of omega(t) from all harmonics", "rad/s", table, &Answer::largest_deviation),
    column("deviation of omega(t) at the end", "rad/s", table, &Answer::final_deviation),
    column("a-priori bound on the change of tau_z at the terminal spin of all harmonics", "N m", table,
           &Answer::bound),
    column("ring radius at the terminal spin", "m", table,
           [=](const Answer &answer) { return answer.load ? answer.load->radius() : nothing; }),
    column("moment ratio at the terminal spin", "1", table,
           [=](const Answer &answer) { return answer.load ? answer.load->moment_ratio() : nothing; }),
    column("minimum of the load at rest", "N/rad", table,
           [](const Answer &answer) { return answer.at_rest.minimum; }),
    column("minimum of the load at the terminal spin", "N/rad", table,
           [=](const Answer &answer) { return answer.at_terminal ? answer.at_terminal->minimum : nothing; }),
    column("share of N that would have to pull at rest", "1", table,
           [](const Answer &answer) { return answer.at_rest.pulling_share; }),
    column("share of N that would have to pull at the terminal spin", "1", table,
           [=](const Answer &answer)
           { return answer.at_terminal ? answer.at_terminal->pulling_share : nothing; }),
    column("1 if the load is negative somewhere", "1", table,
           [](const Answer &answer) { return answer.pulls(); })
  };
  for (std::size_t i = 0; i < study.omega.size(); ++i)
    columns.push_back(column("tau_z at omega = " + formatted("%.9g", study.omega[i]) + " rad/s", "N m", table,
                             [=](const Answer &answer) { return answer.torque[i]; }));
  return data_table("The answer with the load cut off after some harmonics; nan: there is none", columns);
}

std::string spin_up_data(const TruncationStudy &study, const TruncationTable &table)
{
  std::vector<DataColumn> columns = { { "time", "s", study.time } };
  for (const TruncatedAnswer &answer : table.answers)
    if (!answer.spin_up.empty())
      columns.push_back(
        { "omega, harmonics up to " + std::to_string(answer.harmonics), "rad/s", answer.spin_up });
  return data_table("Spin-up from rest", columns);
}

Findings truncation_findings(const Study &study, const RingLoad &load, const TruncationStudy &result)
{
  const bool balanced = result.self_consistent.has_value();
  const TruncationTable &best = main_table(result);
  Findings findings;
  findings.summary = { { "load", load_summary(load) },
                       { "torque_at", result.omega },
                       { "truncation", table_summary(result.frozen) },
                       { "truncation_self_consistent",
                         balanced ? table_summary(*result.self_consistent) : Json(nullptr) },
                       { "why_not_self_consistent", balanced ? Json(nullptr) : Json(result.why_not) } };
  findings.key_figures = {
    { "omega_terminal", number_or_null(best.all().omega_terminal) },
    { "omega_terminal_band",
      result.same_whole_load || !balanced ? number_or_null(result.spin_band) : Json(nullptr) },
    { "relative_change_first_harmonic", number_or_null(result.frozen.answers.front().relative_change) },
    { "relative_change_first_harmonic_self_consistent",
      balanced ? number_or_null(result.self_consistent->answers.front().relative_change) : Json(nullptr) },
    { "closure_effect",
      number_or_null(compare_spins(study, result.closures, *best.all().omega_terminal, 0).closure_effect()) },
    { "harmonics_for_1e-4", harmonics_enough(best, 1e-4) }
  };
  return findings;
}

std::string truncation_answer(const Study &study, const TruncationStudy &result)
{
  std::string text = harmonic_sentences(result);
  const TruncationTable &best = main_table(result);
  if (best.all().relative_change && best.all().harmonics > 1)
    text += formatted(" From %u harmonics on the spin is right to 1e-4.", harmonics_enough(best, 1e-4));
  return text + closure_sentence(compare_spins(study, result.closures, *best.all().omega_terminal, 0));
}

std::string shown_change(const TruncatedAnswer &answer)
{
  const auto &change = answer.relative_change;
  return in_percent(change && std::abs(*change) < spin_rounding ? std::optional<double>(0) : change);
}

std::string shown_torque(const TruncationTable &table, double torque)
{
  if (std::isnan(torque))
    return "-";
  return formatted("%.6g", std::abs(torque) < 1e-12 * std::abs(table.all().tau_at_rest) ? 0 : torque);
}

std::string truncation_text(const TruncationStudy &result)
{
  std::string text =
    "The load cut off, nothing answering (frozen):\n\n" + table_text(result.omega, result.frozen);
  if (result.self_consistent && result.acts_back)
    text += "\nIn balance with the friction of what is left (self-consistent):\n\n" +
            table_text(result.omega, *result.self_consistent);
  else if (!result.self_consistent)
    text += '\n' + wrapped(result.why_not) + '\n';
  return text;
}

std::string shown_deviation(const TruncationTable &table, const std::optional<double> &deviation)
{
  const double scale = std::abs(table.all().omega_terminal.value_or(0));
  return deviation && *deviation <= spin_rounding * scale ? "0" : formatted_or("-", "%.2e", deviation);
}

std::string shown_bound(const TruncatedAnswer &answer)
{
  return answer.bound && *answer.bound == 0 ? "0" : formatted_or("-", "%.2e", answer.bound);
}

unsigned int harmonics_enough(const TruncationTable &table, double share)
{
  unsigned int enough = table.all().harmonics;
  for (auto answer = table.answers.rbegin(); answer != table.answers.rend(); ++answer)
  {
    if (!answer->relative_change || std::abs(*answer->relative_change) > share)
      break;
    enough = answer->harmonics;
  }
  return enough;
}

} // namespace stemware::pipeline
