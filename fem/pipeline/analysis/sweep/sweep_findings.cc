#include "fem/pipeline/analysis/sweep/sweep_findings.h"

#include "fem/pipeline/support/numbers.h"

#include <algorithm>
#include <cmath>

namespace stemware::pipeline
{

namespace
{

/// The value of an entry as it counts for sensitivities.
double score_of(const SweepPlan &plan, std::size_t index, std::size_t entry)
{
  const double value = parse_number(plan.cases.at(index)[entry]).value();
  return plan.spreads[entry].is_by_factors() ? std::log(value) : value;
}

/// A quantity over the cases that have it.
struct QuantitySample
{
  std::vector<std::size_t> cases;
  std::vector<double> values;
};

QuantitySample sample_of(const FinishedCases &cases, std::size_t quantity)
{
  QuantitySample sample;
  for (const auto &[index, result] : cases)
    if (result.is_solved() && result.values[quantity])
    {
      sample.cases.push_back(index);
      sample.values.push_back(*result.values[quantity]);
    }
  return sample;
}

/// Whether some values are positive and others negative, beyond rounding.
bool has_both_signs(const std::vector<double> &values)
{
  if (values.empty())
    return false;
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  const double rounding = 1e-9 * std::max(std::abs(*least), std::abs(*most));
  return *least<-rounding && * most> rounding;
}

QuantityFindings find_out(const SweepPlan &plan, const QuantitySample &sample)
{
  QuantityFindings findings;
  const auto [least, most] = std::minmax_element(sample.values.begin(), sample.values.end());
  const auto case_of = [&](auto place)
  { return sample.cases[static_cast<std::size_t>(place - sample.values.begin())]; };
  findings.n_values = sample.values.size();
  findings.first_case = sample.cases.front();
  findings.least = *least;
  findings.most = *most;
  findings.least_case = case_of(least);
  findings.most_case = case_of(most);
  const double same = 1e-9 * std::max(std::abs(*least), std::abs(*most));
  const auto n_near = [&](double value)
  {
    return static_cast<std::size_t>(std::count_if(sample.values.begin(), sample.values.end(),
                                                  [=](double other)
                                                  { return std::abs(other - value) <= same; }));
  };
  findings.n_least = n_near(*least);
  findings.n_most = n_near(*most);
  if (!plan.is_random() || sample.values.size() < 2)
    return findings;
  findings.band = band_of(sample.values);
  std::vector<std::vector<double>> inputs(plan.entries.size());
  for (std::size_t entry = 0; entry < inputs.size(); ++entry)
    for (const std::size_t index : sample.cases)
      inputs[entry].push_back(score_of(plan, index, entry));
  findings.sensitivity = sensitivity_of(inputs, sample.values);
  if (findings.sensitivity && sample.values.size() < least_samples_of_shares)
    findings.sensitivity->first_order.clear();
  return findings;
}

} // namespace

const QuantityFindings *SweepFindings::about(const std::string &quantity) const
{
  const std::size_t wanted = quantity_index(quantity);
  const auto found = std::find_if(quantities.begin(), quantities.end(),
                                  [=](const QuantityFindings &findings) { return findings.index == wanted; });
  return found == quantities.end() ? nullptr : &*found;
}

bool SweepFindings::spin_changes_sign() const
{
  const QuantityFindings *spin = about("terminal spin");
  return spin != nullptr && has_both_signs({ spin->least, spin->most });
}

FinishedCases reported(FinishedCases cases)
{
  const QuantitySample spins = sample_of(cases, quantity_index("terminal spin"));
  if (!has_both_signs(spins.values))
    return cases;
  for (auto &[index, result] : cases)
    if (result.is_solved())
      result.values[quantity_index("closure effect")].reset();
  return cases;
}

SweepFindings find_out(const SweepPlan &plan, const FinishedCases &cases)
{
  SweepFindings findings;
  findings.n_cases = plan.cases.size();
  for (const auto &[index, result] : cases)
    if (!result.is_solved())
    {
      ++findings.n_failed;
      if (!findings.first_failure)
        findings.first_failure = index;
    }
  for (std::size_t quantity = 0; quantity < sweep_quantities().size(); ++quantity)
  {
    const QuantitySample sample = sample_of(cases, quantity);
    if (sample.values.empty())
      continue;
    findings.quantities.push_back(find_out(plan, sample));
    findings.quantities.back().index = quantity;
  }
  return findings;
}

std::string values_of_case(const SweepPlan &plan, std::size_t index)
{
  std::string text;
  for (std::size_t i = 0; i < plan.entries.size(); ++i)
  {
    const std::string &value = plan.cases.at(index)[i], &unit = plan.entries[i].unit;
    const auto number = unit.empty() ? std::nullopt : parse_number(value);
    text += (i == 0 ? "" : ", ") + plan.entries[i].path + " = " + (number ? to_short_text(*number) : value) +
            (number && unit != "1" ? " " + unit : "");
  }
  return text;
}

} // namespace stemware::pipeline
