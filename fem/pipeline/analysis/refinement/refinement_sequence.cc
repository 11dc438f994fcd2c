#include "fem/pipeline/analysis/refinement/refinement_sequence.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace stemware::pipeline
{

namespace
{

constexpr double safety = 1.25;          ///< of three levels that show an order
constexpr double two_level_safety = 1.5; ///< of two levels, taken as first order
constexpr double wide_safety = 3.;       ///< of anything else
constexpr double least_order = 0.5;      ///< plausible orders
constexpr double greatest_order = 8.;
constexpr double trusted_order = 1.; ///< no higher order narrows a band

/// Largest minus least of the last three values.
double range_of_last(const std::vector<double> &values)
{
  const auto first = values.end() - std::min<std::ptrdiff_t>(3, std::distance(values.begin(), values.end()));
  const auto [least, largest] = std::minmax_element(first, values.end());
  return *largest - *least;
}

/// p of the last three values, if they have a plausible one.
std::optional<double> observed_order(const std::vector<double> &values, double rounding)
{
  if (values.size() < 3)
    return std::nullopt;
  const double *const last = &values.back();
  const double coarse_step = *(last - 1) - *(last - 2);
  const double fine_step = *last - *(last - 1);
  if (std::abs(fine_step) <= rounding || coarse_step * fine_step <= 0)
    return std::nullopt;
  const double order = std::log2(coarse_step / fine_step);
  return least_order <= order && order <= greatest_order ? std::optional(order) : std::nullopt;
}

void judge_algebraic(const std::vector<double> &values, double rounding, RefinementSequence &sequence)
{
  const double fine_step = values.size() > 1 ? values.back() - values[values.size() - 2] : 0;
  sequence.order = observed_order(values, rounding);
  if (!sequence.order)
  {
    const double factor = values.size() == 2 ? two_level_safety : wide_safety;
    sequence.uncertainty = factor * range_of_last(values);
    return;
  }
  sequence.limit += fine_step / (std::exp2(*sequence.order) - 1);
  sequence.uncertainty =
    safety * std::abs(fine_step) / (std::exp2(std::min(*sequence.order, trusted_order)) - 1);
}

void judge_spectral(const std::vector<double> &values, RefinementSequence &sequence)
{
  const auto step = [&](std::size_t from_end)
  {
    return values.size() > from_end
             ? std::abs(values[values.size() - from_end] - values[values.size() - from_end - 1])
             : 0;
  };
  sequence.uncertainty = safety * std::max(step(1), step(2) / 4);
}

} // namespace

RefinementSequence judge_refinement(const std::vector<double> &values, Decay decay, double rounding)
{
  if (values.empty())
    throw std::invalid_argument("A refinement study needs at least one value.");
  if (!std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); }))
    throw std::invalid_argument("A refinement study needs finite values.");
  RefinementSequence sequence;
  sequence.limit = values.back();
  if (decay == Decay::algebraic)
    judge_algebraic(values, rounding, sequence);
  else
    judge_spectral(values, sequence);
  sequence.uncertainty += rounding;
  for (const double value : values)
    sequence.bands.push_back(std::abs(value - values.back()) + sequence.uncertainty);
  return sequence;
}

} // namespace stemware::pipeline
