#include "fem/pipeline/analysis/sweep/sweep_findings.h"

#include "fem/pipeline/support/numbers.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

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

/// The values of a quantity by the cases that have it.
using Sample = std::map<std::size_t, double>;

Sample sample_of(const FinishedCases &cases, std::size_t quantity)
{
  Sample sample;
  for (const auto &[index, result] : cases)
    if (result.is_solved() && result.values[quantity])
      sample.emplace(index, *result.values[quantity]);
  return sample;
}

/// Where the least and the largest value of a sample are.
std::pair<Sample::const_iterator, Sample::const_iterator> extremes_of(const Sample &sample)
{
  return std::minmax_element(sample.begin(), sample.end(),
                             [](const auto &one, const auto &other) { return one.second < other.second; });
}

/// Whether values from @p least to @p most have both signs, beyond rounding.
bool has_both_signs(double least, double most)
{
  const double rounding = 1e-9 * std::max(std::abs(least), std::abs(most));
  return least < -rounding && rounding < most;
}

/// @p sample is not empty.
QuantityFindings find_out(const SweepPlan &plan, std::size_t quantity, const Sample &sample)
{
  const auto [least, most] = extremes_of(sample);
  QuantityFindings findings;
  findings.index = quantity;
  findings.n_values = sample.size();
  findings.first_case = sample.begin()->first;
  std::tie(findings.least_case, findings.least) = *least;
  std::tie(findings.most_case, findings.most) = *most;
  const double same = 1e-9 * std::max(std::abs(findings.least), std::abs(findings.most));
  std::vector<double> values;
  for (const auto &[index, value] : sample)
  {
    values.push_back(value);
    findings.n_least += std::abs(value - findings.least) <= same ? 1 : 0;
    findings.n_most += std::abs(value - findings.most) <= same ? 1 : 0;
  }
  if (!plan.is_random() || values.size() < 2)
    return findings;
  findings.band = band_of(values);
  std::vector<std::vector<double>> inputs(plan.entries.size());
  for (std::size_t entry = 0; entry < inputs.size(); ++entry)
    for (const auto &[index, value] : sample)
      inputs[entry].push_back(score_of(plan, index, entry));
  findings.sensitivity = sensitivity_of(inputs, values);
  if (findings.sensitivity && values.size() < least_samples_of_shares)
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
  return spin != nullptr && has_both_signs(spin->least, spin->most);
}

FinishedCases reported(FinishedCases cases)
{
  const Sample spins = sample_of(cases, quantity_index("terminal spin"));
  const auto [least, most] = extremes_of(spins);
  if (!spins.empty() && has_both_signs(least->second, most->second))
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
    if (const Sample sample = sample_of(cases, quantity); !sample.empty())
      findings.quantities.push_back(find_out(plan, quantity, sample));
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
