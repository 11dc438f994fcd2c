#include "fem/pipeline/analysis/sweep/sweep_findings.h"

#include "fem/pipeline/support/numbers.h"

#include <Eigen/Dense>
#include <boost/math/statistics/univariate_statistics.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <stdexcept>
#include <tuple>
#include <utility>

namespace stemware::pipeline
{

namespace
{

/// The value that is @p share of the way from the smallest to the largest one of a sorted sample.
double percentile(const std::vector<double> &sorted, double share)
{
  const double place = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (place - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

/// Deviations from the mean in units of the standard deviation; a sample without spread stays as zeros.
Eigen::VectorXd standardised(const std::vector<double> &values)
{
  const Eigen::Map<const Eigen::VectorXd> map(values.data(), static_cast<Eigen::Index>(values.size()));
  const Eigen::VectorXd centred = map.array() - map.mean();
  const double deviation = centred.norm() / std::sqrt(static_cast<double>(values.size() - 1));
  // Rounding of equal values is no spread.
  const bool varies = deviation > 1e-13 * map.cwiseAbs().maxCoeff();
  return varies ? Eigen::VectorXd(centred / deviation) : Eigen::VectorXd::Zero(map.size());
}

/// First-order Sobol index Var(E[output | input]) / Var(output), estimated from one sample by the neighbours
/// in the order of the input: (mean of y_j y_next(j) - mean^2) / variance, the first following the last
/// (Gamboa, Gremaud, Klein & Lagnoux, Bernoulli 28 (2022) 2345). Its standard error is of the order of
/// 1/sqrt(samples), so small indices may come out negative.
double first_order_share(const std::vector<double> &input, const std::vector<double> &output)
{
  std::vector<std::size_t> order(input.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return input[a] < input[b]; });
  // Of the centred output, so that nothing cancels.
  const Eigen::VectorXd centred = standardised(output);
  double products = 0;
  for (std::size_t j = 0; j < order.size(); ++j)
    products += centred(static_cast<Eigen::Index>(order[j])) *
                centred(static_cast<Eigen::Index>(order[(j + 1) % order.size()]));
  return products / centred.squaredNorm();
}

/// The values of a quantity by the cases that have it.
using Sample = std::map<std::size_t, double>;

Sample sample_of(const FinishedCases &cases, std::size_t quantity)
{
  Sample sample;
  for (const auto &[index, result] : cases)
    if (const auto value = result.value(quantity))
      sample.emplace(index, *value);
  return sample;
}

/// Differences that are rounding beside the larger one of the ends of a range.
double rounding_of(double least, double most)
{
  return 1e-9 * std::max(std::abs(least), std::abs(most));
}

/// Findings about a quantity; @p sample is not empty.
QuantityFindings range_of(std::size_t quantity, const Sample &sample)
{
  const auto [least, most] =
    std::minmax_element(sample.begin(), sample.end(),
                        [](const auto &one, const auto &other) { return one.second < other.second; });
  QuantityFindings findings;
  findings.index = quantity;
  findings.n_values = sample.size();
  findings.first_case = sample.begin()->first;
  std::tie(findings.least_case, findings.least) = *least;
  std::tie(findings.most_case, findings.most) = *most;
  const double same = rounding_of(findings.least, findings.most);
  for (const auto &[index, value] : sample)
  {
    findings.n_least += std::abs(value - findings.least) <= same ? 1 : 0;
    findings.n_most += std::abs(value - findings.most) <= same ? 1 : 0;
  }
  return findings;
}

/// Adds what random samples tell about a quantity.
void add_statistics(const SweepPlan &plan, const Sample &sample, QuantityFindings &findings)
{
  std::vector<double> values;
  std::vector<std::vector<double>> inputs(plan.entries.size());
  for (const auto &[index, value] : sample)
  {
    values.push_back(value);
    for (std::size_t entry = 0; entry < inputs.size(); ++entry)
    {
      const double input = parse_number(plan.cases.at(index)[entry]).value();
      inputs[entry].push_back(plan.spreads[entry].is_by_factors() ? std::log(input) : input);
    }
  }
  findings.band = band_of(values);
  findings.sensitivity = sensitivity_of(inputs, values);
  if (findings.sensitivity && values.size() < least_samples_of_shares)
    findings.sensitivity->first_order.clear();
}

/// Whether the values have both signs, beyond rounding.
bool has_both_signs(const QuantityFindings &about)
{
  const double rounding = rounding_of(about.least, about.most);
  return about.least < -rounding && rounding < about.most;
}

} // namespace

SampleBand band_of(std::vector<double> values)
{
  if (values.size() < 2)
    throw std::invalid_argument("a band needs at least two values");
  std::sort(values.begin(), values.end());
  SampleBand band;
  band.mean = boost::math::statistics::mean(values);
  band.deviation = std::sqrt(boost::math::statistics::sample_variance(values));
  band.lower = percentile(values, 0.025);
  band.upper = percentile(values, 0.975);
  return band;
}

std::optional<SampleSensitivity> sensitivity_of(const std::vector<std::vector<double>> &inputs,
                                                const std::vector<double> &output)
{
  const auto n_inputs = static_cast<Eigen::Index>(inputs.size());
  const auto n_samples = static_cast<Eigen::Index>(output.size());
  if (n_inputs == 0 || n_samples < n_inputs + 2)
    return std::nullopt;
  Eigen::MatrixXd scores(n_samples, n_inputs);
  for (Eigen::Index i = 0; i < n_inputs; ++i)
    scores.col(i) = standardised(inputs[static_cast<std::size_t>(i)]);
  const Eigen::VectorXd answer = standardised(output);
  if (answer.isZero(0) || (scores.colwise().norm().array() == 0).any())
    return std::nullopt;

  const Eigen::VectorXd coefficients = scores.colPivHouseholderQr().solve(answer);
  SampleSensitivity sensitivity;
  sensitivity.regression.assign(coefficients.begin(), coefficients.end());
  sensitivity.r_squared = 1 - (answer - scores * coefficients).squaredNorm() / answer.squaredNorm();
  for (const std::vector<double> &input : inputs)
    sensitivity.first_order.push_back(first_order_share(input, output));
  return sensitivity;
}

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
  return spin != nullptr && has_both_signs(*spin);
}

FinishedCases reported(FinishedCases cases)
{
  const std::size_t spin = quantity_index("terminal spin"), effect = quantity_index("closure effect");
  const Sample spins = sample_of(cases, spin);
  if (!spins.empty() && has_both_signs(range_of(spin, spins)))
    for (auto &[index, result] : cases)
      if (result.is_solved())
        result.values[effect].reset();
  return cases;
}

SweepFindings find_out(const SweepPlan &plan, const FinishedCases &cases)
{
  SweepFindings findings;
  findings.n_cases = plan.cases.size();
  for (const auto &[index, result] : cases)
    if (!result.is_solved() && findings.n_failed++ == 0)
      findings.first_failure = index;
  for (std::size_t quantity = 0; quantity < sweep_quantities().size(); ++quantity)
  {
    const Sample sample = sample_of(cases, quantity);
    if (sample.empty())
      continue;
    findings.quantities.push_back(range_of(quantity, sample));
    if (plan.is_random() && sample.size() >= 2)
      add_statistics(plan, sample, findings.quantities.back());
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
