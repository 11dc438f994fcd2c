#include "fem/pipeline/analysis/sweep/sample_statistics.h"

#include <Eigen/Dense>
#include <boost/math/statistics/univariate_statistics.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

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

} // namespace

SampleBand band_of(std::vector<double> values)
{
  if (values.size() < 2)
    throw std::invalid_argument("a band needs at least two values");
  std::sort(values.begin(), values.end());
  SampleBand band;
  band.n_values = values.size();
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

} // namespace stemware::pipeline
