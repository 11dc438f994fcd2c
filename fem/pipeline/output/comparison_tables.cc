#include "fem/pipeline/output/comparison_tables.h"

#include "fem/pipeline/output/answer.h"
#include "fem/pipeline/support/numbers.h"
#include "fem/pipeline/support/text_layout.h"

#include <tuple>

namespace stemware::pipeline
{

using Json = nlohmann::ordered_json;

namespace
{

/// What changes a terminal spin, in per cent of where it started.
std::optional<double> effect(const ComparisonRow *from, const ComparisonRow *to)
{
  if (!from || !to || !from->omega_terminal || !to->omega_terminal || *from->omega_terminal == 0)
    return std::nullopt;
  return *to->omega_terminal / *from->omega_terminal - 1;
}

/// "-3.12056 rad/s", or why there is none.
std::string spin(const ComparisonRow &row)
{
  if (!row.omega_terminal)
    return "nothing (" + row.state + ")";
  return with_band(*row.omega_terminal, row.band) + " rad/s" + (row.state == "formal" ? ", formally" : "");
}

/// The kind of load that the study is about, the last one.
const std::string &own_load(const Comparison &comparison)
{
  return comparison.rows.back().load;
}

std::string csv_number(const std::optional<double> &value)
{
  return value ? to_text(*value) : "";
}

} // namespace

std::string harmonics_name(const ComparisonRow &row)
{
  return row.all_harmonics && row.harmonics > 1 ? "all" : std::to_string(row.harmonics);
}

std::string comparison_csv(const Comparison &comparison)
{
  std::string text =
    csv_record({ "closure", "load", "harmonics", "all harmonics", column_title("tau_z at rest", "N m"),
                 column_title("moment ratio at rest", "1"), column_title("terminal omega", "rad/s"),
                 column_title("relative difference to the paper", "1"),
                 column_title("least load at terminal omega", "N/rad"),
                 column_title("contact fraction at terminal omega", "1"), "state", "message" });
  for (const ComparisonRow &row : comparison.rows)
    text +=
      csv_record({ ring::to_string(row.closure), row.load, std::to_string(row.harmonics),
                   row.all_harmonics ? "1" : "0", csv_number(row.tau_at_rest), csv_number(row.moment_ratio),
                   csv_number(row.omega_terminal), csv_number(row.difference), csv_number(row.least_load),
                   csv_number(row.contact_fraction), row.state, row.trouble });
  return text;
}

Findings comparison_findings(const Comparison &comparison)
{
  Findings findings;
  Json rows = Json::array();
  for (const ComparisonRow &row : comparison.rows)
    rows.push_back({ { "closure", ring::to_string(row.closure) },
                     { "load", row.load },
                     { "harmonics", row.harmonics },
                     { "all_harmonics", row.all_harmonics },
                     { "tau_at_rest", number_or_null(row.tau_at_rest) },
                     { "moment_ratio_at_rest", number_or_null(row.moment_ratio) },
                     { "omega_terminal", number_or_null(row.omega_terminal) },
                     { "omega_terminal_band", number_or_null(row.band) },
                     { "difference_to_paper", number_or_null(row.difference) },
                     { "load_minimum_at_terminal", number_or_null(row.least_load) },
                     { "contact_fraction_at_terminal", number_or_null(row.contact_fraction) },
                     { "state", row.state },
                     { "message", row.trouble.empty() ? Json(nullptr) : Json(row.trouble) } });
  const std::string &load = own_load(comparison);
  const auto *paper = comparison.find(ring::Closure::paper, "first harmonic");
  const auto *full = comparison.find(ring::Closure::full, "first harmonic");
  findings.key_figures = { { "closure_effect", number_or_null(effect(paper, full)) },
                           { "harmonic_effect_closure_paper",
                             number_or_null(effect(paper, comparison.find(ring::Closure::paper, load))) },
                           { "harmonic_effect_closure_full",
                             number_or_null(effect(full, comparison.find(ring::Closure::full, load))) } };
  findings.summary = { { "effects", findings.key_figures }, { "comparison", rows } };
  return findings;
}

std::string comparison_answer(const Comparison &comparison)
{
  const std::string &load = own_load(comparison);
  const auto *paper = comparison.find(ring::Closure::paper, "first harmonic");
  const auto *full = comparison.find(ring::Closure::full, "first harmonic");
  std::string text = "With the paper's balance of moments a first-harmonic load reaches " + spin(*paper) +
                     "; what that balance leaves out makes it " + spin(*full);
  if (const auto change = effect(paper, full))
    text += " (closure: " + in_percent(change) + ")";
  text += ".";
  for (const auto &[closure, first, balance] : { std::tuple(ring::Closure::paper, paper, "the paper's"),
                                                 { ring::Closure::full, full, "the complete" } })
  {
    const ComparisonRow &all = *comparison.find(closure, load);
    text += " All harmonics of the " + load + " with " + balance + " balance make it " + spin(all);
    if (const auto change = effect(first, &all))
      text += " (harmonics: " + in_percent(change) + ")";
    text += ".";
  }
  return text;
}

std::string load_title(const ComparisonRow &row, const std::string &at_most)
{
  if (row.harmonics == 1)
    return row.load == "first harmonic" ? row.load : row.load + ", n = 1";
  return row.load + (row.all_harmonics ? ", all" : ", n " + at_most + " " + std::to_string(row.harmonics));
}

std::string comparison_text(const Comparison &comparison)
{
  std::vector<TextColumn> columns = { { "load", {}, true } };
  for (const ComparisonRow &row : comparison.rows)
    if (row.closure == compared_closures[0])
      columns[0].cells.push_back(load_title(row, "<="));
  std::string troubles;
  bool has_formal = false;
  for (const ring::Closure closure : compared_closures)
  {
    TextColumn spins = { ring::to_string(closure) + "\n(rad/s)  ", {} },
               difference = { "to the\npaper's", {} };
    for (const ComparisonRow &row : comparison.rows)
      if (row.closure == closure)
      {
        const bool is_formal = row.state == "formal";
        has_formal = has_formal || is_formal;
        spins.cells.push_back(row.omega_terminal
                                ? formatted("%#.6g", *row.omega_terminal) + (is_formal ? " f" : "  ")
                                : (row.state == "tips" ? "tips  " : "none  "));
        difference.cells.push_back(row.difference ? formatted("%+.3f %%", 100 * *row.difference) : "-");
        if (!row.trouble.empty() && row.all_harmonics)
          troubles += wrapped("closure " + ring::to_string(closure) + ", " + row.load + ": " + row.state +
                              ". " + row.trouble) +
                      "\n";
      }
    columns.insert(columns.end(), { spins, difference });
  }
  std::string text = "Terminal spin by load, harmonics kept and closure:\n\n" + text_table(columns);
  if (has_formal)
    text += "\nf  formal: the load, or what is left of it, would have to pull on the table\n";
  return text + (troubles.empty() ? "" : "\n" + troubles);
}

} // namespace stemware::pipeline
