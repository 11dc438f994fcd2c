#pragma once

#include "fem/pipeline/analysis/sweep/sweep_folder.h"
#include "fem/pipeline/analysis/sweep/sweep_plan.h"

#include <optional>
#include <string>
#include <vector>

namespace stemware::pipeline
{

/// Where the values of a sample lie.
struct SampleBand
{
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
  double r_squared = 0; ///< share of the variance that the linear fit explains
  std::vector<double>
    first_order; ///< first-order Sobol indices Var(E[output | input]) / Var(output), or empty
};

/// @p inputs of shape [input][sample], independent of each other, @p output of shape [sample]. Nothing where
/// the samples are too few to tell (fewer than inputs + 2) or where an input or the output does not vary.
std::optional<SampleSensitivity> sensitivity_of(const std::vector<std::vector<double>> &inputs,
                                                const std::vector<double> &output);

/// Samples from which on shares of the variance are known to about 0.1: their standard error is of the order
/// of 1 / sqrt(samples).
constexpr std::size_t least_samples_of_shares = 100;

/// Findings of a sweep about one quantity. Cases count from 0.
struct QuantityFindings
{
  std::size_t index = 0;    ///< into sweep_quantities()
  std::size_t n_values = 0; ///< cases that have one; at least 1
  double least = 0, most = 0;
  std::size_t first_case = 0;                ///< that has a value
  std::size_t least_case = 0, most_case = 0; ///< the first of them where several cases share the value
  std::size_t n_least = 0, n_most = 0;       ///< how many share it, to 1e-9
  std::optional<SampleBand> band;            ///< of random samples
  /// Sensitivity over random samples, inputs as in SweepPlan::entries; shares of the variance from
  /// least_samples_of_shares samples on only.
  std::optional<SampleSensitivity> sensitivity;

  const SweepQuantity &quantity() const { return sweep_quantities()[index]; }
};

/// Findings of a sweep.
struct SweepFindings
{
  std::size_t n_cases = 0;
  std::size_t n_failed = 0;
  std::optional<std::size_t> first_failure;
  std::vector<QuantityFindings> quantities; ///< those with a value in some case

  /// Findings about the quantity of that name; null where no case has a value.
  const QuantityFindings *about(const std::string &quantity) const;

  /// Whether the terminal spin has one sign in some cases and the other in others; relative differences of
  /// spins then say nothing.
  bool spin_changes_sign() const;
};

/// The cases as they are reported: without "closure effect" where the terminal spin has one sign in some and
/// the other in others. Per cent of a spin that passes through zero tell nothing about what was left out.
FinishedCases reported(FinishedCases cases);

/// Ranges of all quantities; for random samples their bands and sensitivities too, spreads by factors
/// counting in the logarithm.
SweepFindings find_out(const SweepPlan &plan, const FinishedCases &cases);

/// The values of a case: "Load/Moment ratio = 1.3, Table/Foundation modulus = 1e9".
std::string values_of_case(const SweepPlan &plan, std::size_t index);

} // namespace stemware::pipeline
