#include "fem/pipeline/output/sweep_table.h"

#include "fem/pipeline/support/numbers.h"
#include "fem/pipeline/support/text.h"

namespace stemware::pipeline
{

namespace
{

std::vector<std::string> header(const SweepPlan &plan)
{
  std::vector<std::string> titles = { "case" };
  for (const SweptEntry &entry : plan.entries)
    titles.push_back(column_title(entry.path, entry.unit));
  for (const SweepQuantity &quantity : sweep_quantities())
    titles.push_back(column_title(quantity.name, quantity.unit));
  titles.insert(titles.end(), { "contact outcome", "status", "message" });
  return titles;
}

} // namespace

std::string sweep_csv(const SweepPlan &plan, const FinishedCases &cases)
{
  std::string table = csv_record(header(plan));
  for (std::size_t i = 0; i < plan.cases.size(); ++i)
  {
    const CaseResult &result = cases.at(i);
    std::vector<std::string> fields = { std::to_string(i + 1) };
    fields.insert(fields.end(), plan.cases[i].begin(), plan.cases[i].end());
    for (std::size_t q = 0; q < sweep_quantities().size(); ++q)
      fields.push_back(result.is_solved() && result.values[q] ? to_text(*result.values[q]) : "");
    fields.insert(fields.end(), { result.outcome, result.is_solved() ? "ok" : "failed", result.message });
    table += csv_record(fields);
  }
  return table;
}

} // namespace stemware::pipeline
