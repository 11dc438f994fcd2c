#include "fem/pipeline/output/sweep_report.h"

#include "fem/pipeline/output/study_sections.h"
#include "fem/pipeline/support/text_layout.h"

#include <cmath>
#include <map>

namespace stemware::pipeline
{

namespace
{

ReportTable plan_table(const SweepPlan &plan)
{
  ReportTable table = { "What is varied", { "entry", "unit", plan.is_random() ? "spread" : "values" }, {} };
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
    table.rows.push_back({ entry.path, entry.unit, values });
  }
  return table;
}

/// Those that the tables of the report show; the harmonics one by one are for sweep.csv.
std::vector<QuantityFindings> shown(const SweepFindings &findings)
{
  std::vector<QuantityFindings> list;
  for (const QuantityFindings &about : findings.quantities)
    if (sweep_quantities()[about.index].name.find("/a_0") == std::string::npos)
      list.push_back(about);
  return list;
}

/// Where every quantity lies.
ReportTable range_table(const SweepPlan &plan, const SweepFindings &findings)
{
  ReportTable table = { "Least and largest values", { "quantity", "least", "at", "most", "at" }, {} };
  for (const QuantityFindings &about : shown(findings))
  {
    const SweepQuantity &quantity = sweep_quantities()[about.index];
    const bool is_constant = about.most - about.least <= 1e-9 * std::abs(about.most);
    table.rows.push_back({ column_title(quantity.name, quantity.unit), formatted("%.6g", about.least),
                           is_constant ? "everywhere" : values_of_case(plan, about.least_case),
                           formatted("%.6g", about.most),
                           is_constant ? "everywhere" : values_of_case(plan, about.most_case) });
  }
  return table;
}

ReportTable band_table(const SweepFindings &findings)
{
  ReportTable table = { "Bands of all samples",
                        { "quantity", "samples", "mean", "standard deviation", "2.5 %", "97.5 %" },
                        {} };
  for (const QuantityFindings &about : shown(findings))
  {
    if (!about.band)
      continue;
    const SweepQuantity &quantity = sweep_quantities()[about.index];
    table.rows.push_back({ column_title(quantity.name, quantity.unit), std::to_string(about.n_values),
                           formatted("%.6g", about.band->mean), formatted("%.3g", about.band->deviation),
                           formatted("%.6g", about.band->lower), formatted("%.6g", about.band->upper) });
  }
  return table;
}

ReportTable sensitivity_table(const SweepPlan &plan, const std::string &quantity,
                              const SampleSensitivity &sensitivity)
{
  ReportTable table = { "What the " + quantity + " depends on; the linear fit explains " +
                          formatted("%.1f %% of its variance", 100 * sensitivity.r_squared),
                        { "entry", "standardised regression coefficient",
                          "first-order share of the variance" },
                        {} };
  const auto cell = [](double value) { return formatted("%.3f", std::abs(value) < 5e-4 ? 0 : value); };
  for (std::size_t i = 0; i < plan.entries.size(); ++i)
    table.rows.push_back(
      { plan.entries[i].path, cell(sensitivity.regression[i]), cell(sensitivity.first_order[i]) });
  return table;
}

ReportSection sample_section(const SweepPlan &plan, const FinishedCases &cases, const SweepFindings &findings)
{
  ReportSection section = { "Bands and sensitivities",
                            "Independent samples of all entries (seed " + std::to_string(plan.seed) +
                              "). The regression coefficients say by how many standard deviations the "
                              "quantity changes with one of the entry, in "
                              "the best linear fit; entries that spread by factors count in the logarithm. "
                              "The first-order share is the part of "
                              "the variance that would vanish if the entry were known (Sobol's index), "
                              "estimated from neighbours in the order of "
                              "the entry (Gamboa, Gremaud, Klein and Lagnoux, Bernoulli 28, 2022); " +
                              formatted("with %zu samples it is uncertain by about %.2f.", plan.cases.size(),
                                        1 / std::sqrt(static_cast<double>(plan.cases.size()))),
                            sample_figures(plan, cases, findings),
                            {} };
  for (const char *quantity : { "terminal spin", "harmonic effect" })
    if (const QuantityFindings *about = findings.about(quantity); about != nullptr && about->sensitivity)
      section.tables.push_back(sensitivity_table(plan, quantity, *about->sensitivity));
  section.tables.push_back(band_table(findings));
  return section;
}

ReportSection failure_section(const SweepPlan &plan, const FinishedCases &cases)
{
  // Many cases fail for one reason: each is listed once, with the first case that met it.
  std::map<std::string, std::pair<std::size_t, std::size_t>> reasons; // message: first case, number
  for (const auto &[index, result] : cases)
    if (!result.is_solved())
      ++reasons.emplace(result.message, std::pair(index, std::size_t(0))).first->second.second;
  ReportTable table = { "", { "cases", "first of them", "message" }, {} };
  for (const auto &[message, place] : reasons)
    if (table.rows.size() < 20)
      table.rows.push_back({ std::to_string(place.second), values_of_case(plan, place.first), message });
  return { "Cases that failed", "sweep.csv lists all of them.", {}, { table } };
}

ReportSection file_section(const SweepPlan &plan)
{
  ReportSection section;
  section.heading = "Files";
  section.files = { { "sweep.csv", "a row for every case, units in the header" } };
  if (plan.is_random())
    section.files.push_back({ "statistics.csv", "bands and sensitivities of every quantity" });
  section.files.insert(section.files.end(), { { "sweep.json", "how the cases came about" },
                                              { "summary.json", "all findings, for programs" },
                                              { "parameters.prm", "the base study" },
                                              { "timings.json", "how long it took" } });
  return section;
}

} // namespace

Report sweep_report(const SweepPlan &plan, const FinishedCases &cases, const SweepFindings &findings)
{
  Report report = { "Spin of a wine glass in " + std::to_string(plan.cases.size()) +
                      (plan.is_random() ? " random samples" : " cases"),
                    sweep_answer(plan, findings),
                    {} };
  report.sections.push_back({ "The sweep", "", {}, { plan_table(plan) } });
  if (plan.is_random())
    report.sections.push_back(sample_section(plan, cases, findings));
  else
    report.sections.push_back(
      { "What comes out", "", grid_figures(plan, cases), { range_table(plan, findings) } });
  if (findings.n_failed > 0)
    report.sections.push_back(failure_section(plan, cases));
  for (const ReportSection &section : study_sections(plan.base))
    report.sections.push_back(section);
  report.sections.push_back(file_section(plan));
  return report;
}

} // namespace stemware::pipeline
