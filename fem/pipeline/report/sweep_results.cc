#include "fem/pipeline/report/sweep_results.h"

#include "fem/pipeline/report/common_sections.h"
#include "fem/pipeline/report/head.h"
#include "fem/pipeline/report/plots/plots.h"
#include "fem/pipeline/study/study_entries.h"
#include "fem/pipeline/support/numbers.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <set>

namespace stemware::pipeline
{

namespace
{

using Json = nlohmann::ordered_json;

/// Where a quantity has its least or its largest value, which @p n_same cases share.
std::string place_of(const SweepPlan &plan, const QuantityFindings &about, std::size_t index,
                     std::size_t n_same)
{
  if (about.most - about.least <= 1e-9 * std::abs(about.most))
    return "everywhere";
  return n_same > 1 ? std::to_string(n_same) + " cases" : values_of_case(plan, index);
}

/// Quantities by row with where they lie: ranges with the values of their cases, and for random samples bands
/// and sensitivities: the regression on each entry and its share of the variance, one after the other.
Json statistics_rows(const SweepPlan &plan, const SweepFindings &found)
{
  Json rows = Json::array();
  for (const QuantityFindings &about : found.quantities)
  {
    const SweepQuantity &quantity = about.quantity();
    const auto &band = about.band;
    const auto &sensitivity = about.sensitivity;
    Json weights = Json::array();
    for (std::size_t e = 0; e < plan.entries.size(); ++e)
    {
      weights.push_back(sensitivity ? Json(sensitivity->regression[e]) : Json(nullptr));
      // No shares where the samples are too few to tell.
      const bool has_share = sensitivity && !sensitivity->first_order.empty();
      weights.push_back(has_share ? Json(sensitivity->first_order[e]) : Json(nullptr));
    }
    rows.push_back({ { "quantity", quantity.name },
                     { "title", with_unit(quantity.name, quantity.unit, false) },
                     { "unit", quantity.unit },
                     { "values", about.n_values },
                     { "least", about.least },
                     { "least_case", about.least_case + 1 },
                     { "at_least", place_of(plan, about, about.least_case, about.n_least) },
                     { "most", about.most },
                     { "most_case", about.most_case + 1 },
                     { "at_most", place_of(plan, about, about.most_case, about.n_most) },
                     { "mean", band ? Json(band->mean) : Json(nullptr) },
                     { "standard_deviation", band ? Json(band->deviation) : Json(nullptr) },
                     { "percentile_2.5", band ? Json(band->lower) : Json(nullptr) },
                     { "percentile_97.5", band ? Json(band->upper) : Json(nullptr) },
                     { "r_squared", sensitivity ? Json(sensitivity->r_squared) : Json(nullptr) },
                     { "sensitivity", weights } });
  }
  return rows;
}

/// The rows that are wanted.
Json chosen(const Json &rows, const std::function<bool(const Json &)> &is_wanted)
{
  Json some = Json::array();
  std::copy_if(rows.begin(), rows.end(), std::back_inserter(some), is_wanted);
  return some;
}

bool has_band(const Json &row)
{
  return !row["mean"].is_null();
}

/// "statistics.shown" in the report: the harmonics one by one are for sweep.csv, and so are per cent of a
/// spin that changes its sign; "main" on the console; "banded" in statistics.csv.
Json statistics_tables(const Json &rows, bool is_random, bool spin_changes_sign)
{
  static const std::set<std::string> main_quantities = { "moment ratio",
                                                         "contact fraction",
                                                         "torque at rest",
                                                         "terminal spin",
                                                         "terminal spin of the first harmonic alone",
                                                         "absolute harmonic effect",
                                                         "harmonic effect" };
  const Json told = chosen(rows, [=](const Json &row) { return !spin_changes_sign || row["unit"] != "%"; });
  const auto is_shown = [=](const Json &row)
  {
    return row["quantity"].get<std::string>().find("/a_0") == std::string::npos &&
           (!is_random || has_band(row));
  };
  return { { "shown", chosen(told, is_shown) },
           { "main",
             chosen(told, [](const Json &row) { return main_quantities.count(row["quantity"]) > 0; }) },
           { "banded", chosen(rows, has_band) } };
}

/// Sensitivity of the quantity of a row to each entry.
Json sensitivity_rows(const SweepPlan &plan, const Json &row)
{
  Json rows = Json::array();
  for (std::size_t i = 0; i < plan.entries.size(); ++i)
    rows.push_back({ { "entry", plan.entries[i].path },
                     { "regression", row["sensitivity"][2 * i] },
                     { "first_order", row["sensitivity"][2 * i + 1] } });
  return rows;
}

// ---- summary.json

Json quantity_summary(const SweepPlan &plan, const Json &row)
{
  Json summary = picked(row, "unit values least least_case most most_case");
  if (has_band(row))
    summary["band"] = picked(row, "mean standard_deviation percentile_2.5 percentile_97.5");
  if (row["r_squared"].is_null())
    return summary;
  summary["sensitivity"] = { { "r_squared", row["r_squared"] }, { "entries", Json::object() } };
  for (const Json &entry : sensitivity_rows(plan, row))
    summary["sensitivity"]["entries"][entry["entry"]] = picked(entry, "regression first_order");
  return summary;
}

Findings findings_of(const SweepPlan &plan, const SweepFindings &found, const Json &rows)
{
  static const std::map<std::string, std::string> keys = { { "terminal spin", "omega_terminal" },
                                                           { "absolute harmonic effect", "harmonic_effect" },
                                                           { "harmonic effect", "harmonic_effect_percent" } };
  Json sweep = plan_as_json(plan);
  sweep["failed"] = found.n_failed;
  Findings findings;
  findings.summary = { { "sweep", sweep }, { "quantities", Json::object() } };
  findings.key_figures = { { "cases", found.n_cases }, { "failed", found.n_failed } };
  for (const Json &row : rows)
  {
    const std::string quantity = row["quantity"];
    findings.summary["quantities"][quantity] = quantity_summary(plan, row);
    if (const auto key = keys.find(quantity); key != keys.end())
      findings.key_figures[key->second] = has_band(row)
                                            ? Json{ row["percentile_2.5"], row["percentile_97.5"] }
                                            : Json{ row["least"], row["most"] };
  }
  return findings;
}

// ---- report

/// The swept entries by their paths, in words: "200 g … 400 g".
std::map<std::string, std::string> swept_words(const SweepPlan &plan)
{
  std::map<std::string, std::string> words;
  for (std::size_t i = 0; i < plan.entries.size(); ++i)
  {
    const SweptEntry &entry = plan.entries[i];
    const auto value_words = [&](const std::string &value)
    {
      const std::optional<double> number = parse_number(value);
      return number ? in_words(*number, entry.unit) : value;
    };
    std::string &text = words[entry.path];
    if (plan.is_random())
    {
      Study base = plan.base;
      text = "about " + in_words(base, entry_at(study_entries(base), "", entry.path));
    }
    else
      text = value_words(entry.values.front()) + (entry.values.size() > 2 ? " … " : ", ") +
             value_words(entry.values.back());
  }
  return words;
}

/// The glasses with the least and the largest terminal spin, where all cases go round one orbit.
std::vector<TurningGlass> extreme_glasses(const SweepPlan &plan, const SweepFindings &findings)
{
  const QuantityFindings *spin = findings.about("terminal spin");
  for (const SweptEntry &entry : plan.entries)
    if (entry.path.rfind("Motion/Orbit", 0) == 0 || entry.path == "Glass/Contact radius")
      return {};
  if (spin == nullptr)
    return {};
  const bool one_sense = spin->least * spin->most >= 0;
  const bool least_is_fast = std::abs(spin->least) > std::abs(spin->most);
  const auto title = [&](bool is_least)
  {
    return !one_sense                  ? (is_least ? "fastest clockwise" : "fastest counter-clockwise")
           : is_least == least_is_fast ? "the fastest"
                                       : "the slowest";
  };
  return { { title(true), spin->least }, { title(false), spin->most } };
}

/// A value of a sweep as it is shown: a number with six digits.
std::string shown(const std::string &value)
{
  const std::optional<double> number = parse_number(value);
  return number ? to_short_text(*number) : value;
}

/// Varied entries with their units and values.
Json plan_rows(const SweepPlan &plan)
{
  Json rows = Json::array();
  for (std::size_t i = 0; i < plan.entries.size(); ++i)
  {
    const SweptEntry &entry = plan.entries[i];
    std::string values;
    if (plan.is_random())
      values = plan.spreads[i].description();
    else if (entry.values.size() > (entry.by_factors ? 4 : 8))
      values = std::to_string(entry.values.size()) + " values from " + shown(entry.values.front()) + " to " +
               shown(entry.values.back()) + (entry.by_factors ? ", by equal factors" : "");
    else
      for (const std::string &value : entry.values)
        values += (values.empty() ? "" : ", ") + shown(value);
    rows.push_back({ { "entry", entry.path },
                     { "unit", entry.unit == "1" ? format::missing : entry.unit },
                     { plan.is_random() ? "spread" : "values", values } });
  }
  return rows;
}

/// Adds what the terminal spin and the harmonic effect depend on.
void add_sensitivities(const SweepPlan &plan, const Json &rows, Json &facts)
{
  constexpr double rounding = 5e-4;
  facts["sensitivities"] = Json::array();
  for (const Json &row : rows)
  {
    const std::string quantity = row["quantity"];
    if (row["r_squared"].is_null() || !(quantity == "terminal spin" || quantity == "harmonic effect"))
      continue;
    const bool has_shares = !row["sensitivity"][1].is_null();
    const std::string weights = has_shares ? "regression first_order" : "regression";
    Json &shown = facts["sensitivity"][quantity] = picked(sensitivity_rows(plan, row), "entry " + weights);
    leave_out_rounding(shown, weights, rounding);
    facts["sensitivities"].push_back({ { "quantity", quantity }, { "r_squared", row["r_squared"] } });
  }
}

/// The reasons why cases failed: each is listed once, with the first case that met it.
Json failure_rows(const SweepPlan &plan, const FinishedCases &cases)
{
  std::map<std::string, std::pair<std::size_t, std::size_t>> reasons; // message: first case, number
  for (const auto &[index, result] : cases)
    if (!result.is_solved())
      ++reasons.emplace(result.message, std::pair(index, std::size_t(0))).first->second.second;
  Json rows = Json::array();
  for (const auto &[message, place] : reasons)
    if (rows.size() < 20)
      rows.push_back({ { "cases", place.second },
                       { "first of them", values_of_case(plan, place.first) },
                       { "message", message } });
  return rows;
}

/// sweep.csv: a row for every case of the plan in its order: case (from 1), the varied entries as they were
/// given, sweep_quantities(), contact outcome, status and message. What a case does not have is missing.
Json case_rows(const SweepPlan &plan, const FinishedCases &cases)
{
  Json rows = Json::array();
  for (std::size_t i = 0; i < plan.cases.size(); ++i)
  {
    const CaseResult &result = cases.at(i);
    Json row = { { "case", i + 1 } };
    for (std::size_t e = 0; e < plan.entries.size(); ++e)
      row[with_unit(plan.entries[e].path, plan.entries[e].unit)] = plan.cases[i].at(e);
    for (std::size_t q = 0; q < sweep_quantities().size(); ++q)
      row[with_unit(sweep_quantities()[q].name, sweep_quantities()[q].unit)] = result.value(q);
    row["contact outcome"] = result.outcome;
    row["status"] = result.falls_over() ? "tips" : result.is_solved() ? "ok" : "failed";
    row["message"] = result.message;
    rows.push_back(row);
  }
  return rows;
}

/// The columns of statistics.csv that say by how much each entry counts.
Json sensitivity_quantities(const SweepPlan &plan)
{
  Json list = Json::array();
  for (const SweptEntry &entry : plan.entries)
  {
    list.push_back({ { "name", "regression on " + entry.path } });
    list.push_back({ { "name", "first-order share of " + entry.path } });
  }
  return list;
}

} // namespace

Results tabulate(const SweepPlan &plan, const FinishedCases &cases, const SweepFindings &findings)
{
  const Json rows = statistics_rows(plan, findings);
  const std::size_t n = plan.cases.size();
  const std::map<std::string, std::string> swept = swept_words(plan);
  const bool has_shares = findings.n_cases - findings.n_failed >= least_samples_of_shares;
  Document document = { findings_of(plan, findings, rows), sweep_facts(plan, findings) };
  document.facts.update({
    { "sweep_size", std::to_string(n) + (plan.is_random() ? " random samples" : " cases") },
    { "random", plan.is_random() },
    { "seed", plan.seed },
    { "n_samples", n },
    { "share_error", has_shares ? Json(1 / std::sqrt(static_cast<double>(n))) : Json(nullptr) },
    { "samples_of_shares", least_samples_of_shares },
  });
  add_study(plan.base, extreme_glasses(plan, findings), document, {}, swept);
  Json varied = Json::array();
  for (const auto &[path, words] : swept)
    varied.push_back({ { "entry", path.substr(path.find('/') + 1) }, { "words", words } });
  document.facts["varied"] = varied;
  document.facts["has_orbits"] = !document.facts["orbits"]["glasses"].empty();
  add_sweep_plots(plan, cases, findings, document);
  add_sensitivities(plan, rows, document.facts);
  document.facts["plan"] = plan_rows(plan);
  document.facts["failures"] = failure_rows(plan, cases);
  document.facts["statistics"] = statistics_tables(rows, plan.is_random(), findings.spin_changes_sign());
  const Json &main = document.facts["statistics"]["main"];
  document.facts["has_bands"] = std::any_of(main.begin(), main.end(), has_band);
  document.facts["case_table"] = case_rows(plan, cases);
  document.quantities["statistics"]["sensitivity[]"] = sensitivity_quantities(plan);
  document.texts["plan_json"] = plan_as_json(plan).dump(2) + "\n";
  return shown(document, "sweep");
}

} // namespace stemware::pipeline
