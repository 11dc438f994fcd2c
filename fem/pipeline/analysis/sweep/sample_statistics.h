#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace stemware::pipeline
{

/// Where the values of a sample lie.
struct SampleBand
{
  std::size_t n_values = 0;
  double mean = 0;
  double deviation = 0; ///< standard deviation, with n - 1
  double lower = 0;     ///< 2.5 % of the values are smaller
  double upper = 0;     ///< 97.5 % of the values are smaller
};

/// Band of at least two values; between neighbours the percentiles go linearly (Hyndman & Fan, Am. Stat. 50
/// (1996) 361, definition 7). Throws std::invalid_argument for fewer values.
SampleBand band_of(std::vector<double> values);

/// How much an output owes to the inputs of a random sample.
struct SampleSensitivity
{
  /// Standardised regression coefficients: standard deviations of the output per standard deviation of each
  /// input in the best linear fit.
  std::vector<double> regression;
  double r_squared = 0;            ///< share of the variance that the linear fit explains
  std::vector<double> first_order; ///< first_order_share() of each input, or empty
};

/// @p inputs of shape [input][sample], independent of each other, @p output of shape [sample]. Nothing where
/// the samples are too few to tell (fewer than inputs + 2) or where an input or the output does not vary.
std::optional<SampleSensitivity> sensitivity_of(const std::vector<std::vector<double>> &inputs,
                                                const std::vector<double> &output);

/// First-order Sobol index Var(E[output | input]) / Var(output), estimated from one sample by the neighbours
/// in the order of the input: (mean of y_j y_next(j) - mean^2) / variance, the first following the last
/// (Gamboa, Gremaud, Klein & Lagnoux, Bernoulli 28 (2022) 2345). Its standard error is of the order of
/// 1/sqrt(samples), so small indices may come out negative.
double first_order_share(const std::vector<double> &input, const std::vector<double> &output);

} // namespace stemware::pipeline
