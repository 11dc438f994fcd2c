#include "fem/pipeline/report/sweep_results.h"

#include "fem/pipeline/report/common_sections.h"
#include "fem/pipeline/report/facts.h"
#include "fem/pipeline/report/head.h"
#include "fem/pipeline/report/plots/plots.h"
#include "fem/pipeline/report/quantities.h"
#include "fem/pipeline/report/render/table_renderers.h"
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
  const Table table = statistics_table(plan, { about });
  Json summary = json_row(table.with("", "unit values least least_case most most_case"));
  if (about.band)
    summary["band"] = json_row(table.with("", "mean standard_deviation percentile_2.5 percentile_97.5"));
  if (const auto &sensitivity = about.sensitivity)
  {
    Json entries = Json::object();
    for (std::size_t i = 0; i < plan.entries.size(); ++i)
      entries[plan.entries[i].path] = { { "regression", sensitivity->regression[i] },
                                        { "first_order", json_number(share_of(*sensitivity, i)) } };
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
Table plan_table(const SweepPlan &plan)
{
  std::vector<std::vector<std::string>> rows;
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
    rows.push_back({ entry.path, entry.unit == "1" ? "–" : entry.unit, values });
  }
  return words("What is varied", { "entry", "unit", plan.is_random() ? "spread" : "values" }, rows);
}

/// Sensitivity of a quantity to each entry.
Table sensitivity_table(const SweepPlan &plan, const std::string &quantity,
                        const SampleSensitivity &sensitivity)
{
  constexpr double rounding = 5e-4;
  Table table = { "What the " + quantity + " depends on; the linear fit explains " +
                    format::percent_fixed<1>(sensitivity.r_squared) + " of its variance",
                  { column(quantity::entry, plan.entries, &SweptEntry::path),
                    column(
                      quantity::regression, sensitivity.regression, [](double value) { return value; },
                      rounding) } };
  if (!sensitivity.first_order.empty())
    table.columns.push_back(column(
      quantity::first_order, sensitivity.first_order, [](double value) { return value; }, rounding));
  return table;
}

Table failure_table(const SweepPlan &plan, const FinishedCases &cases)
{
  // Many cases fail for one reason: each is listed once, with the first case that met it.
  std::map<std::string, std::pair<std::size_t, std::size_t>> reasons; // message: first case, number
  for (const auto &[index, result] : cases)
    if (!result.is_solved())
      ++reasons.emplace(result.message, std::pair(index, std::size_t(0))).first->second.second;
  std::vector<std::vector<std::string>> rows;
  for (const auto &[message, place] : reasons)
    if (rows.size() < 20)
      rows.push_back({ std::to_string(place.second), values_of_case(plan, place.first), message });
  return words("", { "cases", "first of them", "message" }, rows);
}

} // namespace

Table case_table(const SweepPlan &plan, const FinishedCases &cases)
{
  std::vector<std::size_t> indices(plan.cases.size());
  for (std::size_t i = 0; i < indices.size(); ++i)
    indices[i] = i;
  const auto of_case = [&](const Quantity &quantity, auto value)
  { return column(quantity, indices, [&cases, value](std::size_t i) { return value(cases.at(i)); }); };
  Table table = { "", { column(quantity::case_number, indices, [](std::size_t i) { return i + 1; }) } };
  for (std::size_t e = 0; e < plan.entries.size(); ++e)
    table.columns.push_back(column(Quantity("", plan.entries[e].path, plan.entries[e].unit), plan.cases,
                                   [=](const std::vector<std::string> &values) { return values.at(e); }));
  for (std::size_t q = 0; q < sweep_quantities().size(); ++q)
    table.columns.push_back(of_case(Quantity("", sweep_quantities()[q].name, sweep_quantities()[q].unit),
                                    [=](const CaseResult &result)
                                    { return result.is_solved() ? result.values.at(q) : std::nullopt; }));
  table.columns.push_back(
    of_case(quantity::case_outcome, [](const CaseResult &result) { return result.outcome; }));
  table.columns.push_back(
    of_case(quantity::case_status, [](const CaseResult &result)
            { return result.falls_over()  ? "tips"
                     : result.is_solved() ? "ok"
                                          : "failed"; }));
  table.columns.push_back(
    of_case(quantity::message, [](const CaseResult &result) { return result.message; }));
  return table;
}

Table statistics_table(const SweepPlan &plan, const std::vector<QuantityFindings> &quantities)
{
  using Row = QuantityFindings;
  const auto title = [](const Row &row)
  { return with_unit(row.quantity().name, row.quantity().unit, false); };
  const auto place = [&](std::size_t Row::*index)
  {
    return [&plan, index](const Row &row)
    {
      const bool is_constant = row.most - row.least <= 1e-9 * std::abs(row.most);
      const std::size_t n_same = index == &Row::least_case ? row.n_least : row.n_most;
      return is_constant  ? "everywhere"
             : n_same > 1 ? std::to_string(n_same) + " cases"
                          : values_of_case(plan, row.*index);
    };
  };
  const auto band = [](double SampleBand::*value)
  { return [=](const Row &row) { return row.band ? std::optional(*row.band.*value) : std::nullopt; }; };
  const auto r_squared = [](const Row &row)
  { return row.sensitivity ? std::optional(row.sensitivity->r_squared) : std::nullopt; };
  Table table = {
    "",
    { column(quantity::quantity_name, quantities, [](const Row &row) { return row.quantity().name; }),
      column(quantity::quantity_name.with(&Quantity::key, "title"), quantities, title),
      column(quantity::unit, quantities, [](const Row &row) { return row.quantity().unit; }),
      column(quantity::values_found, quantities, &Row::n_values),
      column(quantity::least, quantities, &Row::least),
      column(quantity::least_case, quantities, [](const Row &row) { return row.least_case + 1; }),
      column(quantity::place_of_least, quantities, place(&Row::least_case)),
      column(quantity::most, quantities, &Row::most),
      column(quantity::most_case, quantities, [](const Row &row) { return row.most_case + 1; }),
      column(quantity::place_of_most, quantities, place(&Row::most_case)),
      column(quantity::mean, quantities, band(&SampleBand::mean)),
      column(quantity::deviation, quantities, band(&SampleBand::deviation)),
      column(quantity::percentile_low, quantities, band(&SampleBand::lower)),
      column(quantity::percentile_high, quantities, band(&SampleBand::upper)),
      column(quantity::r_squared, quantities, r_squared) }
  };
  for (std::size_t e = 0; e < plan.entries.size(); ++e)
  {
    const auto coefficient = [=](const Row &row)
    { return row.sensitivity ? std::optional(row.sensitivity->regression.at(e)) : std::nullopt; };
    const auto share = [=](const Row &row)
    { return row.sensitivity ? share_of(*row.sensitivity, e) : std::nullopt; };
    const std::string &path = plan.entries[e].path;
    table.columns.push_back(column(
      quantity::regression.with(&Quantity::key, "sensitivity").with(&Quantity::name, "regression on " + path),
      quantities, coefficient));
    table.columns.push_back(column(quantity::first_order.with(&Quantity::key, "sensitivity")
                                     .with(&Quantity::name, "first-order share of " + path),
                                   quantities, share));
  }
  return table;
}

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
  add_head(plan.base, extreme_glasses(plan, findings), document, {}, swept);
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
      document.tables["sensitivity_" + std::string(quantity)] =
        sensitivity_table(plan, quantity, *about->sensitivity);
      document.facts["sensitivities"].push_back(quantity);
    }
  document.tables["plan"] = plan_table(plan);
  document.tables["shown_statistics"] =
    statistics_table(plan, plan.is_random() ? with_bands(people) : people);
  document.tables["main_statistics"] = statistics_table(plan, main);
  document.tables["statistics"] = statistics_table(plan, with_bands(findings.quantities));
  document.tables["failures"] = failure_table(plan, cases);
  document.tables["cases"] = case_table(plan, cases);
  document.texts["plan_json"] = plan_as_json(plan).dump(2) + "\n";
  add_study(plan.base, document);
  return shown(document, "sweep");
}

} // namespace stemware::pipeline
