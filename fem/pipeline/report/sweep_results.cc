#include "fem/pipeline/report/sweep_results.h"

#include "fem/pipeline/report/answer.h"
#include "fem/pipeline/report/common_sections.h"
#include "fem/pipeline/report/plots/plots.h"
#include "fem/pipeline/report/quantities.h"
#include "fem/pipeline/report/render/table_renderers.h"

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

/// Those that the tables of the report show: the harmonics one by one are for sweep.csv, and so are per cent
/// of a spin that changes its sign.
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

/// Those that the console shows.
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

ReportSection plan_section(const SweepPlan &plan)
{
  std::vector<std::vector<std::string>> rows;
  for (std::size_t i = 0; i < plan.entries.size(); ++i)
  {
    const SweptEntry &entry = plan.entries[i];
    std::string values;
    if (plan.is_random())
      values = plan.spreads[i].description();
    else if (entry.values.size() > 8)
      values = std::to_string(entry.values.size()) + " values from " + entry.values.front() + " to " +
               entry.values.back() + (entry.by_factors ? ", by equal factors" : "");
    else
      for (const std::string &value : entry.values)
        values += (values.empty() ? "" : ", ") + value;
    rows.push_back({ entry.path, entry.unit == "1" ? "–" : entry.unit, values });
  }
  return { "The sweep",
           "",
           {},
           { words("What is varied", { "entry", "unit", plan.is_random() ? "spread" : "values" }, rows) } };
}

/// What a quantity depends on, entry by entry.
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

ReportSection sample_section(const SweepPlan &plan, const FinishedCases &cases, const SweepFindings &findings)
{
  ReportSection section = {
    "Bands and sensitivities",
    fmt::format(
      FMT_STRING("Independent samples of all entries (seed {}). The regression coefficients say by how many "
                 "standard deviations the quantity changes with one of the entry, in the best linear fit; "
                 "entries that spread by factors count in the logarithm. "),
      plan.seed) +
      (findings.n_cases - findings.n_failed >= least_samples_of_shares
         ? fmt::format(
             FMT_STRING(
               "The first-order share is the part of the variance that would vanish if the entry were known "
               "(Sobol's index), estimated from neighbours in the order of the entry (Gamboa, Gremaud, Klein "
               "and Lagnoux, Bernoulli 28, 2022); with {} samples it is uncertain by about {:.2f}."),
             plan.cases.size(), 1 / std::sqrt(static_cast<double>(plan.cases.size())))
         : fmt::format(FMT_STRING("Shares of the variance (Sobol's indices) need {} samples or more; give "
                                  "--samples."),
                       least_samples_of_shares)),
    sample_plots(plan, cases, findings)
  };
  for (const char *quantity : { "terminal spin", "harmonic effect" })
    if (const QuantityFindings *about = findings.about(quantity); about != nullptr && about->sensitivity)
      section.tables.push_back(sensitivity_table(plan, quantity, *about->sensitivity));
  section.tables.push_back(
    statistics_table(plan, with_bands(for_people(findings)))
      .with("Bands of all samples", "title values mean standard_deviation percentile_2.5 percentile_97.5"));
  return section;
}

ReportSection grid_section(const SweepPlan &plan, const FinishedCases &cases, const SweepFindings &findings)
{
  return { "What comes out",
           "",
           grid_plots(plan, cases),
           { statistics_table(plan, for_people(findings))
               .with("Least and largest values", "title least at_least most at_most") } };
}

ReportSection failure_section(const SweepPlan &plan, const FinishedCases &cases)
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
  return { "Cases that failed",
           "sweep.csv lists all of them.",
           {},
           { words("", { "cases", "first of them", "message" }, rows) } };
}

std::vector<ResultFile> files_of(const SweepPlan &plan, const FinishedCases &cases,
                                 const SweepFindings &findings)
{
  std::vector<ResultFile> files = { { "sweep.csv", "a row for every case, units in the header",
                                      case_table(plan, cases) } };
  if (plan.is_random())
    files.push_back({ "statistics.csv", "bands and sensitivities of every quantity",
                      statistics_table(plan, with_bands(findings.quantities))
                        .with("", "quantity unit values mean standard_deviation percentile_2.5 "
                                  "percentile_97.5 r_squared sensitivity") });
  files.push_back({ "sweep.json", "how the cases came about", plan_as_json(plan).dump(2) + "\n" });
  files.push_back({ "summary.json", "all findings, for programs" });
  files.push_back({ "parameters.prm", "the base study" });
  files.push_back({ "timings.json", "how long it took" });
  return files;
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
  Results results;
  results.files = files_of(plan, cases, findings);
  results.report = { "Spin of a wine glass in " + std::to_string(plan.cases.size()) +
                       (plan.is_random() ? " random samples" : " cases"),
                     sweep_answer(plan, findings),
                     { plan_section(plan), plan.is_random() ? sample_section(plan, cases, findings)
                                                            : grid_section(plan, cases, findings) } };
  if (findings.n_failed > 0)
    results.report.sections.push_back(failure_section(plan, cases));
  if (is_one_way(plan.base))
    say_one_way(results.report);
  add_closing_sections(results.report, plan.base, results.files);
  const std::vector<QuantityFindings> main = main_quantities(findings);
  const bool has_bands = std::any_of(main.begin(), main.end(), has_band);
  results.console = { { results.report.answer,
                        statistics_table(plan, main)
                          .with("", has_bands ? "title mean standard_deviation percentile_2.5 percentile_97.5"
                                              : "title least most") } };
  results.findings = findings_of(plan, findings);
  return results;
}

} // namespace stemware::pipeline
