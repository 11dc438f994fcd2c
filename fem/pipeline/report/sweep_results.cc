#include "fem/pipeline/report/sweep_results.h"

#include "fem/pipeline/report/common_sections.h"
#include "fem/pipeline/report/head.h"
#include "fem/pipeline/report/plots/plots.h"
#include "fem/pipeline/study/study_entries.h"
#include "fem/pipeline/support/numbers.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

namespace stemware::pipeline
{

namespace
{

using Json = nlohmann::ordered_json;

bool has_band(const QuantityFindings &about)
{
  return about.band.has_value();
}

std::vector<QuantityFindings> with_bands(std::vector<QuantityFindings> list)
{
  list.erase(std::remove_if(list.begin(), list.end(), std::not_fn(has_band)), list.end());
  return list;
}

/// Quantities in the tables of the report: the harmonics one by one are for sweep.csv, and so are per cent of
/// a spin that changes its sign.
std::vector<QuantityFindings> for_people(const SweepFindings &findings)
{
  const bool has_relative = !findings.spin_changes_sign();
  std::vector<QuantityFindings> list;
  for (const QuantityFindings &about : findings.quantities)
    if (about.quantity().name.find("/a_0") == std::string::npos &&
        (has_relative || about.quantity().unit != "%"))
      list.push_back(about);
  return list;
}

/// First-order share of an entry; nothing where the samples are too few to tell.
std::optional<double> share_of(const SampleSensitivity &sensitivity, std::size_t entry)
{
  return sensitivity.first_order.empty() ? std::nullopt : std::optional(sensitivity.first_order.at(entry));
}

/// Where a quantity has its least or its largest value, which @p n_same cases share.
std::string place_of(const SweepPlan &plan, const QuantityFindings &about, std::size_t index,
                     std::size_t n_same)
{
  if (about.most - about.least <= 1e-9 * std::abs(about.most))
    return "everywhere";
  return n_same > 1 ? std::to_string(n_same) + " cases" : values_of_case(plan, index);
}

/// Quantities by row with where they lie: ranges with the values of their cases, and for random samples bands
/// and sensitivities, those of each entry in two places of a list.
Json statistics_rows(const SweepPlan &plan, const std::vector<QuantityFindings> &quantities)
{
  Json rows = Json::array();
  for (const QuantityFindings &about : quantities)
  {
    const SweepQuantity &quantity = about.quantity();
    const auto of_band = [&](double SampleBand::*value)
    { return about.band ? Json(*about.band.*value) : Json(nullptr); };
    Json sensitivity = Json::array();
    for (std::size_t e = 0; e < plan.entries.size(); ++e)
    {
      const auto &found = about.sensitivity;
      sensitivity.push_back(found ? Json(found->regression.at(e)) : Json(nullptr));
      sensitivity.push_back(found ? share_of(*found, e) : std::nullopt);
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
                     { "mean", of_band(&SampleBand::mean) },
                     { "standard_deviation", of_band(&SampleBand::deviation) },
                     { "percentile_2.5", of_band(&SampleBand::lower) },
                     { "percentile_97.5", of_band(&SampleBand::upper) },
                     { "r_squared", about.sensitivity ? Json(about.sensitivity->r_squared) : Json(nullptr) },
                     { "sensitivity", sensitivity } });
  }
  return rows;
}

/// Quantities on the console.
std::vector<QuantityFindings> main_quantities(const SweepFindings &findings)
{
  std::vector<QuantityFindings> list;
  const std::string relative = "harmonic effect";
  for (const std::string name :
       { "moment ratio", "contact fraction", "torque at rest", "terminal spin",
         "terminal spin of the first harmonic alone", "absolute harmonic effect", "harmonic effect" })
    if (const QuantityFindings *about = findings.about(name);
        about != nullptr && !(name == relative && findings.spin_changes_sign()))
      list.push_back(*about);
  return list;
}

// ---- summary.json

Json quantity_summary(const SweepPlan &plan, const QuantityFindings &about)
{
  const Json row = statistics_rows(plan, { about })[0];
  Json summary = picked(row, "unit values least least_case most most_case");
  if (about.band)
    summary["band"] = picked(row, "mean standard_deviation percentile_2.5 percentile_97.5");
  if (const auto &sensitivity = about.sensitivity)
  {
    Json entries = Json::object();
    for (std::size_t i = 0; i < plan.entries.size(); ++i)
      entries[plan.entries[i].path] = { { "regression", sensitivity->regression[i] },
                                        { "first_order", share_of(*sensitivity, i) } };
    summary["sensitivity"] = { { "r_squared", sensitivity->r_squared }, { "entries", entries } };
  }
  return summary;
}

Findings findings_of(const SweepPlan &plan, const SweepFindings &found)
{
  Json quantities = Json::object();
  for (const QuantityFindings &about : found.quantities)
    quantities[about.quantity().name] = quantity_summary(plan, about);
  Json sweep = plan_as_json(plan);
  sweep["failed"] = found.n_failed;
  Findings findings;
  findings.summary = { { "sweep", sweep }, { "quantities", quantities } };
  findings.key_figures = { { "cases", found.n_cases }, { "failed", found.n_failed } };
  for (const auto &[key, quantity] : { std::pair("omega_terminal", "terminal spin"),
                                       std::pair("harmonic_effect", "absolute harmonic effect"),
                                       std::pair("harmonic_effect_percent", "harmonic effect") })
    if (const QuantityFindings *about = found.about(quantity))
      findings.key_figures[key] =
        about->band ? Json{ about->band->lower, about->band->upper } : Json{ about->least, about->most };
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

/// Sensitivity of a quantity to each entry, for people.
Json sensitivity_rows(const SweepPlan &plan, const SampleSensitivity &sensitivity)
{
  constexpr double rounding = 5e-4;
  Json rows = Json::array();
  for (std::size_t i = 0; i < plan.entries.size(); ++i)
  {
    rows.push_back({ { "entry", plan.entries[i].path }, { "regression", sensitivity.regression.at(i) } });
    if (const auto share = share_of(sensitivity, i))
      rows.back()["first_order"] = *share;
  }
  leave_out_rounding(rows, "regression", rounding);
  if (!sensitivity.first_order.empty())
    leave_out_rounding(rows, "first_order", rounding);
  return rows;
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
      row[with_unit(sweep_quantities()[q].name, sweep_quantities()[q].unit)] =
        result.is_solved() ? result.values.at(q) : std::nullopt;
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
  const std::vector<QuantityFindings> main = main_quantities(findings), people = for_people(findings);
  const std::size_t n = plan.cases.size();
  const std::map<std::string, std::string> swept = swept_words(plan);
  const bool has_shares = findings.n_cases - findings.n_failed >= least_samples_of_shares;
  Document document = { findings_of(plan, findings), sweep_facts(plan, findings) };
  document.facts.update(
    { { "sweep_size", std::to_string(n) + (plan.is_random() ? " random samples" : " cases") },
      { "random", plan.is_random() },
      { "seed", plan.seed },
      { "n_samples", n },
      { "share_error", has_shares ? Json(1 / std::sqrt(static_cast<double>(n))) : Json(nullptr) },
      { "samples_of_shares", least_samples_of_shares },
      { "has_bands", std::any_of(main.begin(), main.end(), has_band) },
      { "sensitivities", Json::array() } });
  add_study(plan.base, extreme_glasses(plan, findings), document, {}, swept);
  Json varied = Json::array();
  for (const auto &[path, words] : swept)
    varied.push_back({ { "entry", path.substr(path.find('/') + 1) }, { "words", words } });
  document.facts["varied"] = varied;
  document.facts["has_orbits"] = !document.facts["orbits"]["glasses"].empty();
  add_sweep_plots(plan, cases, findings, document);
  for (const char *quantity : { "terminal spin", "harmonic effect" })
    if (const QuantityFindings *about = findings.about(quantity);
        plan.is_random() && about != nullptr && about->sensitivity)
    {
      document.facts["sensitivity"][quantity] = sensitivity_rows(plan, *about->sensitivity);
      document.facts["sensitivities"].push_back(
        { { "quantity", quantity }, { "r_squared", about->sensitivity->r_squared } });
    }
  document.facts["plan"] = plan_rows(plan);
  document.facts["failures"] = failure_rows(plan, cases);
  document.facts["statistics"] = { { "shown",
                                     statistics_rows(plan, plan.is_random() ? with_bands(people) : people) },
                                   { "main", statistics_rows(plan, main) },
                                   { "banded", statistics_rows(plan, with_bands(findings.quantities)) } };
  document.facts["case_table"] = case_rows(plan, cases);
  document.quantities["statistics"]["sensitivity[]"] = sensitivity_quantities(plan);
  document.texts["plan_json"] = plan_as_json(plan).dump(2) + "\n";
  return shown(document, "sweep");
}

} // namespace stemware::pipeline
