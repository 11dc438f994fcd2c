#include "fem/pipeline/report/sweep_results.h"

#include "fem/pipeline/document/sweep_file.h"
#include "fem/pipeline/report/common_sections.h"
#include "fem/pipeline/report/head.h"
#include "fem/pipeline/report/plots/plots.h"
#include "fem/pipeline/support/numbers.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace stemware::pipeline
{

namespace
{

using Json = nlohmann::ordered_json;

/// Smallest and largest value of a quantity and the cases that have them; null if no case has a value.
Json range_facts(const CaseList &list, const FinishedCases &finished, const std::string &key)
{
  const std::pair<const std::size_t, CaseResult> *min = nullptr, *max = nullptr;
  std::size_t n = 0;
  for (const auto &one : finished)
    if (const auto value = one.second.value(key))
    {
      ++n;
      min = min == nullptr || *value < *min->second.value(key) ? &one : min;
      max = max == nullptr || *value > *max->second.value(key) ? &one : max;
    }
  if (n == 0)
    return nullptr;
  return { { "n", n },
           { "one", n == 1 },
           { "min", *min->second.value(key) },
           { "min_case", list.values_of(min->first) },
           { "max", *max->second.value(key) },
           { "max_case", list.values_of(max->first) } };
}

/// Ranges of the quantities of the table in the report and on the console.
Json range_rows(const CaseList &list, const FinishedCases &finished)
{
  Json rows = Json::array();
  for (const char *key : { "omega_terminal", "omega_first_harmonic", "omega_on_ring", "harmonic_effect",
                           "tau_at_rest", "moment_ratio", "contact_fraction" })
    if (const Json range = range_facts(list, finished, key); !range.is_null())
    {
      const Quantity quantity = quantity_named(key, "sweep.csv");
      rows.push_back({ { "quantity", heading_with_unit(quantity) },
                       { "least", range["min"] },
                       { "at_least", range["min_case"] },
                       { "most", range["max"] },
                       { "at_most", range["max_case"] } });
    }
  return rows;
}

/// Varied entries with their units and values.
Json varied_rows(const CaseList &list)
{
  Json rows = Json::array();
  for (std::size_t e = 0; e < list.entries.size(); ++e)
  {
    const VariedEntry &entry = list.entries[e];
    const auto shown = [](const std::string &value)
    {
      const auto number = parse_number(value);
      return number ? to_short_text(*number) : value;
    };
    std::string values;
    if (!list.is_grid())
      values = "from the list";
    else if (entry.values.size() > (entry.by_factors ? 4 : 8))
      values = std::to_string(entry.values.size()) + " values from " + shown(entry.values.front()) + " to " +
               shown(entry.values.back()) + (entry.by_factors ? ", by equal factors" : "");
    else
      for (const std::string &value : entry.values)
        values += (values.empty() ? "" : ", ") + shown(value);
    rows.push_back({ { "entry", entry.path },
                     { "unit", entry.unit == "1" ? format::missing : entry.unit },
                     { "values", values } });
  }
  return rows;
}

/// Reasons why cases failed, each with the first case that has it.
Json failure_rows(const CaseList &list, const FinishedCases &finished)
{
  constexpr std::size_t max_rows = 20;
  std::map<std::string, std::pair<std::size_t, std::size_t>> reasons; // message: first case, number
  for (const auto &[index, result] : finished)
    if (!result.is_solved())
      ++reasons.emplace(result.message, std::pair(index, std::size_t(0))).first->second.second;
  Json rows = Json::array();
  for (const auto &[message, place] : reasons)
    if (rows.size() < max_rows)
      rows.push_back({ { "cases", place.second },
                       { "first of them", list.values_of(place.first) },
                       { "message", message } });
  return rows;
}

/// Ends of a range for --json; null if there is none.
Json ends_of(const Json &range)
{
  return range.is_null() ? range : Json{ range["min"], range["max"] };
}

} // namespace

Results sweep_results(const CaseList &list, const FinishedCases &finished)
{
  const auto n_failed =
    std::count_if(finished.begin(), finished.end(), [](const auto &one) { return !one.second.is_solved(); });
  const Json spin = range_facts(list, finished, "omega_terminal"),
             effect = range_facts(list, finished, "harmonic_effect");
  Json entries = Json::array();
  for (const VariedEntry &entry : list.entries)
    entries.push_back({ { "entry", entry.path }, { "unit", entry.unit } });
  Document document;
  document.findings.summary["sweep"] = { { "cases", list.cases.size() },
                                         { "finished", finished.size() },
                                         { "failed", n_failed },
                                         { "entries", entries } };
  document.findings.key_figures = { { "cases", list.cases.size() },
                                    { "finished", finished.size() },
                                    { "failed", n_failed },
                                    { "omega_terminal", ends_of(spin) },
                                    { "harmonic_effect", ends_of(effect) } };
  document.facts = study_facts(list.base);
  document.facts.update({ { "n_cases", list.cases.size() },
                          { "n_finished", finished.size() },
                          { "is_part", finished.size() < list.cases.size() },
                          { "n_failed", n_failed > 0 ? Json(n_failed) : Json(nullptr) },
                          { "spin", spin },
                          { "effect", effect },
                          { "falls", range_facts(list, finished, "omega_fall") },
                          { "varied", varied_rows(list) },
                          { "ranges", range_rows(list, finished) },
                          { "failures", failure_rows(list, finished) } });
  add_study(list.base, {}, document);
  add_sweep_plots(list, finished, document);
  return shown(document, "sweep");
}

} // namespace stemware::pipeline
