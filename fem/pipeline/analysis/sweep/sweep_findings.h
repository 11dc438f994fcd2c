#pragma once

#include "fem/pipeline/analysis/sweep/case_log.h"
#include "fem/pipeline/analysis/sweep/sample_statistics.h"
#include "fem/pipeline/analysis/sweep/sweep_plan.h"

#include <optional>
#include <string>
#include <vector>

namespace stemware::pipeline
{

/// What a sweep says about one quantity. Cases count from 0.
struct QuantityFindings
{
  std::size_t index = 0;    ///< into sweep_quantities()
  std::size_t n_values = 0; ///< cases that have one; at least 1
  double least = 0, most = 0;
  std::size_t least_case = 0, most_case = 0;
  std::optional<SampleBand> band;               ///< of random samples
  std::optional<SampleSensitivity> sensitivity; ///< of random samples, inputs as in SweepPlan::entries

  const SweepQuantity &quantity() const { return sweep_quantities()[index]; }
};

/// What a sweep has found out.
struct SweepFindings
{
  std::size_t n_cases = 0;
  std::size_t n_failed = 0;
  std::optional<std::size_t> first_failure;
  std::vector<QuantityFindings> quantities; ///< those with a value in some case

  /// What is said about the quantity of that name; null where no case has a value.
  const QuantityFindings *about(const std::string &quantity) const;
};

/// Ranges of all quantities; for random samples their bands and sensitivities too, spreads by factors
/// counting in the logarithm.
SweepFindings find_out(const SweepPlan &plan, const FinishedCases &cases);

/// The values of a case: "Load/Moment ratio = 1.3, Table/Foundation modulus = 1e9".
std::string values_of_case(const SweepPlan &plan, std::size_t index);

} // namespace stemware::pipeline
