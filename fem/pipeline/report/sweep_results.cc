#include "fem/pipeline/report/sweep_results.h"

#include "fem/pipeline/document/answers.h"
#include "fem/pipeline/document/sentences.h"
#include "fem/pipeline/document/study_words.h"
#include "fem/pipeline/support/numbers.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace stemware::pipeline
{

namespace
{

using Json = nlohmann::ordered_json;

/// Ranges of the quantities of the table in the report and on the console.
Json range_rows(const CaseList &list, const FinishedCases &finished)
{
  Json rows = Json::array();
  for (const char *key : { "omega_terminal", "omega_first_harmonic", "omega_on_ring", "harmonic_effect",
                           "tau_at_rest", "moment_ratio", "contact_fraction" })
    if (const auto range = range_of(list, finished, key))
      rows.push_back({ { "quantity", heading_with_unit(quantity_named(key, "sweep.csv")) },
                       { "least", range->min },
                       { "at_least", range->min_case },
                       { "most", range->max },
                       { "at_most", range->max_case } });
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
    if (result.has_failed())
      ++reasons.emplace(result.message, std::pair(index, std::size_t(0))).first->second.second;
  Json rows = Json::array();
  for (const auto &[message, place] : reasons)
    if (rows.size() < max_rows)
      rows.push_back({ { "cases", place.second },
                       { "first of them", list.values_of(place.first) },
                       { "message", message } });
  return rows;
}

/// A grid for its pictures: the entries, and quantities with their values case by case; null if missing.
Json grid_of(const CaseList &list, const FinishedCases &finished)
{
  Json grid = { { "entries", Json::array() }, { "quantities", Json::object() } };
  for (const VariedEntry &entry : list.entries)
    grid["entries"].push_back({ { "label", entry.path.substr(entry.path.find('/') + 1) },
                                { "unit", entry.unit },
                                { "log", entry.by_factors },
                                { "values", entry.values } });
  for (const char *key : { "omega_terminal", "omega_first_harmonic", "omega_on_ring", "omega_fall",
                           "harmonic_effect", "contact_fraction", "tau_at_rest" })
  {
    Json values = Json::array();
    for (std::size_t i = 0; i < list.cases.size(); ++i)
    {
      const auto found = finished.find(i);
      const auto value = found == finished.end() ? std::nullopt : found->second.value(key);
      values.push_back(shortened(value.value_or(std::nan("")), 9));
    }
    const Quantity quantity = quantity_named(key, "sweep.csv");
    grid["quantities"][key] = { { "label", quantity.heading },
                                { "unit", quantity.unit },
                                { "values", values } };
  }
  return grid;
}

/// Ends of a range for --json; null if there is none.
Json ends_of(const std::optional<CaseRange> &range)
{
  return range ? Json{ range->min, range->max } : Json(nullptr);
}

} // namespace

Results sweep_results(const CaseList &list, const FinishedCases &finished)
{
  const auto n_failed =
    std::count_if(finished.begin(), finished.end(), [](const auto &one) { return one.second.has_failed(); });
  const Json ranges = range_rows(list, finished);
  Json entries = Json::array();
  for (const VariedEntry &entry : list.entries)
    entries.push_back({ { "entry", entry.path }, { "unit", entry.unit } });
  Results results = { document_of(list.base, "its spin in " + std::to_string(list.cases.size()) + " cases") };
  results.findings.summary["sweep"] = { { "cases", list.cases.size() },
                                        { "finished", finished.size() },
                                        { "failed", n_failed },
                                        { "entries", entries } };
  results.findings.key_figures = { { "cases", list.cases.size() },
                                   { "finished", finished.size() },
                                   { "failed", n_failed },
                                   { "omega_terminal", ends_of(range_of(list, finished, "omega_terminal")) },
                                   { "harmonic_effect",
                                     ends_of(range_of(list, finished, "harmonic_effect")) } };
  results.words["answer"] = sweep_answer(list, finished);
  results.add_rows("varied", varied_rows(list));
  results.add_rows("ranges", ranges, "quantity least at_least most at_most");
  if (n_failed > 0)
    results.add_rows("failures", failure_rows(list, finished));
  if (list.is_grid())
    results.tables["grid"] = grid_of(list, finished);
  results.files = { { "sweep.csv", "a row for each case: entries, numbers, status, message" },
                    { "summary.json", "numbers of cases" },
                    { "parameters.prm", "the study that the cases modify" },
                    { "timings.json", "how long it took" } };
  results.console = { { results.words["answer"], table_of(ranges, "quantity least most", "ranges") } };
  return results;
}

} // namespace stemware::pipeline
