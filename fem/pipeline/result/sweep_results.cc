#include "fem/pipeline/result/sweep_results.h"

#include "fem/pipeline/base/numbers.h"
#include "fem/pipeline/result/answers.h"
#include "fem/pipeline/result/number_format.h"
#include "fem/pipeline/result/sentences.h"
#include "fem/pipeline/result/study_words.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace stemware::pipeline
{

namespace
{

/// Quantities that the table of ranges and the pictures of a grid show: those with a heading.
std::vector<Quantity> shown_quantities()
{
  std::vector<Quantity> quantities;
  for (const auto &[quantity, value] : study_quantities().all())
    if (!quantity.heading.empty())
      quantities.push_back(quantity);
  return quantities;
}

/// Range of a quantity over the cases.
struct RangeRow
{
  Quantity quantity;
  CaseRange range;
};

Table range_table(const CaseList &list, const FinishedCases &finished, Face face)
{
  static const auto fields = Fields<RangeRow>{
    { "quantity", "", "",
      [](const RangeRow &row) { return with_unit(row.quantity.heading, row.quantity.unit, false); },
      shown_as("quantity") },
    { "least", "1", "", [](const RangeRow &row) { return row.range.min; }, shown_as("smallest") },
    { "at_least", "", "", [](const RangeRow &row) { return row.range.min_case; }, on_page("at") },
    { "most", "1", "", [](const RangeRow &row) { return row.range.max; }, shown_as("largest") },
    { "at_most", "", "", [](const RangeRow &row) { return row.range.max_case; }, on_page("at") }
  };
  std::vector<RangeRow> rows;
  for (const Quantity &quantity : shown_quantities())
    if (const auto range = range_of(list, finished, quantity.key))
      rows.push_back({ quantity, *range });
  return fields.table(rows, face);
}

/// Varied entries with their units and values.
Table varied_table(const CaseList &list)
{
  const auto values_of = [&](const VariedEntry &entry)
  {
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
    return values;
  };
  return Fields<VariedEntry>{
    { "entry", "", "", &VariedEntry::path, on_page("entry") },
    { "unit", "", "",
      [](const VariedEntry &entry) { return entry.unit == "1" ? format::missing : entry.unit; },
      on_page("unit") },
    { "values", "", "", values_of, on_page("values") }
  }.table(list.entries, Face::page);
}

/// Reason why cases failed.
struct FailureRow
{
  std::size_t n_cases;
  std::string first, message;
};

/// Reasons why cases failed, each with the first case that has it.
Table failure_table(const CaseList &list, const FinishedCases &finished)
{
  constexpr std::size_t max_rows = 20;
  std::map<std::string, std::pair<std::size_t, std::size_t>> reasons; // message: first case, number
  for (const auto &[index, result] : finished)
    if (result.has_failed())
      ++reasons.emplace(result.message, std::pair(index, std::size_t(0))).first->second.second;
  static const auto fields =
    Fields<FailureRow>{ { "cases", "1", "", &FailureRow::n_cases, on_page("cases") },
                        { "first of them", "", "", &FailureRow::first, on_page("first of them") },
                        { "message", "", "", &FailureRow::message, on_page("message") } };
  std::vector<FailureRow> rows;
  for (const auto &[message, place] : reasons)
    if (rows.size() < max_rows)
      rows.push_back({ place.second, list.values_of(place.first), message });
  return fields.table(rows, Face::page);
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
  for (const Quantity &quantity : shown_quantities())
  {
    Json values = Json::array();
    for (std::size_t i = 0; i < list.cases.size(); ++i)
    {
      const auto found = finished.find(i);
      const auto value = found == finished.end() ? std::nullopt : found->second.value(quantity.key);
      values.push_back(shortened(value.value_or(std::nan("")), 9));
    }
    grid["quantities"][quantity.key] = { { "label", quantity.heading },
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

/// Source of the members of `sweep`'s summary.
struct SweepRow
{
  const CaseList &list;
  std::size_t n_finished, n_failed;
};

const Fields<SweepRow> &sweep_fields()
{
  static const auto entry_fields =
    Fields<VariedEntry>{ { "entry", "", "Section/Entry.", &VariedEntry::path },
                         { "unit", "", "Unit of the values; empty for words.", &VariedEntry::unit } };
  static const auto case_fields = Fields<SweepRow>{
    { "cases", "", "Number of cases.", [](const SweepRow &row) { return row.list.cases.size(); } },
    { "finished", "", "Cases that are finished: rows of sweep.csv.", &SweepRow::n_finished },
    { "failed", "", "Finished cases without an answer.", &SweepRow::n_failed },
    { "entries", "Entries that differ from case to case.", entry_fields,
      [](const SweepRow &row) { return row.list.entries; } }
  };
  static const auto fields =
    Fields<SweepRow>{ { "sweep", "Cases of `sweep`; sweep.csv has their numbers.", case_fields,
                        [](const SweepRow &row) -> const SweepRow & { return row; } } };
  return fields;
}

} // namespace

Json sweep_schema()
{
  return sweep_fields().schema();
}

Results sweep_results(const CaseList &list, const FinishedCases &finished)
{
  const auto n_failed = static_cast<std::size_t>(
    std::count_if(finished.begin(), finished.end(), [](const auto &one) { return one.second.has_failed(); }));
  Results results = { document_of(list.base, "its spin in " + std::to_string(list.cases.size()) + " cases") };
  results.findings.summary = sweep_fields().json({ list, finished.size(), n_failed });
  results.findings.key_figures = { { "cases", list.cases.size() },
                                   { "finished", finished.size() },
                                   { "failed", n_failed },
                                   { "omega_terminal", ends_of(range_of(list, finished, "omega_terminal")) },
                                   { "harmonic_effect",
                                     ends_of(range_of(list, finished, "harmonic_effect")) } };
  results.words["answer"] = sweep_answer(list, finished);
  results.add_table("varied", varied_table(list));
  results.add_table("ranges", range_table(list, finished, Face::page));
  if (n_failed > 0)
    results.add_table("failures", failure_table(list, finished));
  if (list.is_grid())
    results.tables["grid"] = grid_of(list, finished);
  results.files = { { "sweep.csv", "a row for each case: entries, numbers, status, message" },
                    { "summary.json", "numbers of cases" },
                    { "parameters.prm", "the study that the cases modify" },
                    { "timings.json", "how long it took" } };
  results.console = { { results.words["answer"], range_table(list, finished, Face::console) } };
  return results;
}

} // namespace stemware::pipeline
