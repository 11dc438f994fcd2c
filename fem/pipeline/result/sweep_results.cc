#include "fem/pipeline/base/numbers.h"
#include "fem/pipeline/result/number_format.h"
#include "fem/pipeline/result/sentences.h"
#include "fem/pipeline/result/verb_results.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace stemware::pipeline
{

namespace
{

/// Range of a quantity over the cases. `min_case` and `max_case`: cases with the smallest and largest value.
struct QuantityRange
{
  Quantity quantity;
  std::size_t n; ///< number of cases with a value
  double min, max;
  std::string min_case, max_case; ///< both are "all n cases" if the values are equal to within 1e-9
};

/// Returns the ranges of all quantities that have a heading and at least one value. Cases with a tensile load
/// (status formal) are omitted.
std::vector<QuantityRange> ranges_of(const CaseList &list, const FinishedCases &finished)
{
  std::vector<QuantityRange> ranges;
  for (const auto &[quantity, value_of] : all_quantities().all())
  {
    std::map<double, std::size_t> cases; // index of a case with this value
    std::size_t n = 0;
    for (const auto &[index, result] : finished)
      if (const auto value = result.value(quantity.key); value && result.status != "formal")
      {
        cases.emplace(*value, index);
        ++n;
      }
    if (quantity.heading.empty() || n == 0)
      continue;
    const auto &[min, min_index] = *cases.begin();
    const auto &[max, max_index] = *cases.rbegin();
    const bool is_same = n > 1 && max - min <= 1e-9 * std::max(std::abs(min), std::abs(max));
    const std::string all = "all " + std::to_string(n) + " cases";
    ranges.push_back({ quantity, n, min, max, is_same ? all : list.values_of(min_index),
                       is_same ? all : list.values_of(max_index) });
  }
  return ranges;
}

const QuantityRange *range_of(const std::vector<QuantityRange> &ranges, const std::string &key)
{
  const auto found = std::find_if(ranges.begin(), ranges.end(),
                                  [&](const QuantityRange &range) { return range.quantity.key == key; });
  return found == ranges.end() ? nullptr : &*found;
}

Table range_table(const std::vector<QuantityRange> &ranges, Face face)
{
  return Fields<QuantityRange>{
    { "quantity", "", "",
      [](const QuantityRange &row) { return with_unit(row.quantity.heading, row.quantity.unit, false); },
      shown_as("quantity") },
    { "least", "1", "", &QuantityRange::min, shown_as("smallest") },
    { "at_least", "", "", &QuantityRange::min_case, on_page("at") },
    { "most", "1", "", &QuantityRange::max, shown_as("largest") },
    { "at_most", "", "", &QuantityRange::max_case, on_page("at") }
  }.table(ranges, face);
}

std::size_t n_with_status(const FinishedCases &finished, const std::string &status)
{
  return static_cast<std::size_t>(std::count_if(
    finished.begin(), finished.end(), [&](const auto &one) { return one.second.status == status; }));
}

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

struct FailureRow
{
  std::size_t n_cases;
  std::string first, message;
};

Table failure_table(const CaseList &list, const FinishedCases &finished)
{
  constexpr std::size_t max_rows = 20;
  std::map<std::string, FailureRow> reasons; // by message
  for (const auto &[index, result] : finished)
    if (result.status == "failed")
      ++reasons.try_emplace(result.message, FailureRow{ 0, list.values_of(index), result.message })
          .first->second.n_cases;
  std::vector<FailureRow> rows;
  for (const auto &[message, row] : reasons)
    if (rows.size() < max_rows)
      rows.push_back(row);
  return Fields<FailureRow>{
    { "cases", "1", "", &FailureRow::n_cases, on_page("cases") },
    { "first of them", "", "", &FailureRow::first, on_page("first of them") },
    { "message", "", "", &FailureRow::message, on_page("message") }
  }.table(rows, Face::page);
}

/// Returns the varied entries with their values, and the values of each quantity: one per case, null if
/// missing.
Json grid_of(const CaseList &list, const FinishedCases &finished)
{
  Json grid = { { "entries", Json::array() }, { "quantities", Json::object() } };
  for (const VariedEntry &entry : list.entries)
    grid["entries"].push_back({ { "label", entry.path.substr(entry.path.find('/') + 1) },
                                { "unit", entry.unit },
                                { "log", entry.by_factors },
                                { "values", entry.values } });
  for (const auto &[quantity, value_of] : all_quantities().all())
  {
    if (quantity.heading.empty())
      continue;
    Json values = Json::array();
    for (std::size_t i = 0; i < list.cases.size(); ++i)
    {
      const auto found = finished.find(i);
      const auto value = found == finished.end() ? std::nullopt : found->second.value(quantity.key);
      values.push_back(rounded_number(value.value_or(std::nan("")), 9));
    }
    grid["quantities"][quantity.key] = { { "label", quantity.heading },
                                         { "unit", quantity.unit },
                                         { "values", values } };
  }
  return grid;
}

std::string answer_of(const CaseList &list, const FinishedCases &finished,
                      const std::vector<QuantityRange> &ranges)
{
  const std::string of_cases = " of " + std::to_string(list.cases.size()) + " cases ";
  std::string text;
  if (const QuantityRange *falls = range_of(ranges, "omega_fall"))
    append(text, "In " + std::to_string(falls->n) + of_cases +
                   "the glass stands at rest and tips over while it spins up" +
                   (falls->n == 1 ? " (" + falls->min_case + "); it has"
                                  : ", one of them " + falls->min_case + "; they have") +
                   " no terminal spin.");
  if (const auto n_at_rest = std::count_if(
        finished.begin(), finished.end(),
        [](const auto &one) { return one.second.status == "tips" && one.second.values.empty(); }))
    append(text, "In " + std::to_string(n_at_rest) + of_cases + "the glass tips before it spins.");
  if (const std::size_t n_formal = n_with_status(finished, "formal"))
    append(text, "In " + std::to_string(n_formal) + of_cases +
                   "the load is negative somewhere (tensile, not physical): their status is formal, and the "
                   "ranges leave them out.");
  if (const QuantityRange *spin = range_of(ranges, "omega_terminal"))
    append(text,
           under_its_load(list.base.load, "In " + std::to_string(spin->n) +
                                            (spin->n == 1 ? " case" : " cases") + " the terminal spin is ") +
             (spin->min_case == spin->max_case
                ? format::spin(spin->min) + " rad/s (" + spin->min_case + ")."
                : "between " + format::spin(spin->min) + " rad/s (" + spin->min_case + ") and " +
                    format::spin(spin->max) + " rad/s (" + spin->max_case + ")."));
  if (const QuantityRange *effect = range_of(ranges, "harmonic_effect"))
  {
    const double largest = std::max(effect->max, -effect->min);
    if (list.base.is_spin(largest) && effect->min_case != effect->max_case)
      append(text, "The higher harmonics of the " + one_way_word(list.base.load) +
                     "load change the spin by " + format::number(effect->min, "+.3g") + " rad/s (" +
                     effect->min_case + ") to " + format::number(effect->max, "+.3g") + " rad/s (" +
                     effect->max_case + ").");
    else if (largest != 0) // the effect is the same in all cases
      append(text, harmonic_effect_sentence(list.base, { effect->max, std::nullopt }));
  }
  if (const std::size_t n_failed = n_with_status(finished, "failed"))
    append(text, std::to_string(n_failed) + " of " + std::to_string(finished.size()) +
                   " cases failed; sweep.csv gives the reasons in the column message.");
  return text;
}

struct SweepRow
{
  const CaseList &list;
  std::size_t n_finished, n_failed;
};

Fields<SweepRow> sweep_fields()
{
  const auto entry_fields =
    Fields<VariedEntry>{ { "entry", "", "Section/Entry.", &VariedEntry::path },
                         { "unit", "", "Unit of the values; empty for words.", &VariedEntry::unit } };
  const auto case_fields = Fields<SweepRow>{
    { "cases", "", "Number of cases.", [](const SweepRow &row) { return row.list.cases.size(); } },
    { "finished", "", "Cases that are finished: rows of sweep.csv.", &SweepRow::n_finished },
    { "failed", "", "Finished cases without an answer.", &SweepRow::n_failed },
    { "entries", "Entries that differ from case to case.", entry_fields,
      [](const SweepRow &row) { return row.list.entries; } }
  };
  return { { "sweep", "Cases of `sweep`; sweep.csv has their numbers.", case_fields,
             [](const SweepRow &row) -> const SweepRow & { return row; } } };
}

} // namespace

Json sweep_schema()
{
  return sweep_fields().schema();
}

Results sweep_results(const CaseList &list, const FinishedCases &finished)
{
  const std::size_t n_failed = n_with_status(finished, "failed");
  const std::vector<QuantityRange> ranges = ranges_of(list, finished);
  Results results = begun_results(list.base, "its spin in " + std::to_string(list.cases.size()) + " cases");
  results.summary = sweep_fields().json({ list, finished.size(), n_failed });
  const auto ends_of = [&](const char *key)
  {
    const QuantityRange *range = range_of(ranges, key);
    return range ? Json{ range->min, range->max } : Json(nullptr);
  };
  results.key_figures = { { "cases", list.cases.size() },
                          { "finished", finished.size() },
                          { "failed", n_failed },
                          { "omega_terminal", ends_of("omega_terminal") },
                          { "harmonic_effect", ends_of("harmonic_effect") } };
  results.words["answer"] = answer_of(list, finished, ranges);
  results.add_table("varied", varied_table(list));
  results.add_table("ranges", range_table(ranges, Face::page));
  if (n_failed > 0)
    results.add_table("failures", failure_table(list, finished));
  if (list.is_grid())
    results.tables["grid"] = grid_of(list, finished);
  results.files = { { "sweep.csv", "a row for each case: entries, numbers, status, message" },
                    { "summary.json", "numbers of cases" },
                    { "parameters.prm", "the study that the cases modify" },
                    { "timings.json", "how long it took" } };
  results.console = { results.words["answer"].get<std::string>(), range_table(ranges, Face::console) };
  return results;
}

} // namespace stemware::pipeline
