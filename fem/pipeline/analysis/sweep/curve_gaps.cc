#include "fem/pipeline/analysis/sweep/curve_gaps.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace stemware::pipeline
{

namespace
{

constexpr double factor = 4; ///< "much" for a jump

/// Intervals between the values of a curve in which it jumps: one of them, or two side by side, over which
/// the curve changes more than four times as much as over those to their left and right.
std::vector<bool> jumps_of(const std::vector<double> &y)
{
  std::vector<double> steps;
  for (std::size_t i = 0; i + 1 < y.size(); ++i)
    steps.push_back(std::abs(y[i + 1] - y[i]));
  std::vector<bool> jumps(steps.size(), false);
  for (const std::ptrdiff_t width : { 1, 2 })
    for (std::size_t i = 1; i + static_cast<std::size_t>(width) < steps.size(); ++i)
    {
      const auto first = steps.begin() + static_cast<std::ptrdiff_t>(i), last = first + width;
      if (!std::all_of(first - 1, last + 1, [](double step) { return std::isfinite(step); }))
        continue; // beside a case that has failed
      const double smallest = *std::min_element(first, last), beside = std::max(*(first - 1), *last);
      if (smallest > factor * beside && beside > 1e-9 * smallest) // rounding beside a step tells nothing
        std::fill_n(jumps.begin() + static_cast<std::ptrdiff_t>(i), width, true);
    }
  return jumps;
}

/// Intervals in which a spin changes its sign, together with the values between that are zero, where they are
/// too wide to tell how: the curve changes more than four times as much there as over the intervals beside,
/// or there are none beside.
std::vector<bool> unresolved_changes_of_sign(const std::vector<double> &y)
{
  std::vector<bool> unresolved(y.empty() ? 0 : y.size() - 1, false);
  double largest = 0;
  for (const double value : y)
    largest = std::isfinite(value) ? std::max(largest, std::abs(value)) : largest;
  const auto is_zero = [&](std::size_t i) { return std::abs(y[i]) <= 1e-9 * largest; };
  const auto step = [&](std::size_t i) { return std::abs(y[i + 1] - y[i]); };
  for (std::size_t first = 0; first + 1 < y.size(); ++first)
  {
    std::size_t last = first + 1;
    while (last + 1 < y.size() && is_zero(last))
      ++last;
    if (is_zero(first) || !(y[first] * y[last] < 0))
      continue;
    double beside = 0, smallest = step(first);
    for (std::size_t i = first; i < last; ++i)
      smallest = std::min(smallest, step(i));
    if (first > 0 && std::isfinite(step(first - 1)))
      beside = step(first - 1);
    if (last + 1 < y.size() && std::isfinite(step(last)))
      beside = std::max(beside, step(last));
    if (smallest > factor * beside)
      std::fill(unresolved.begin() + static_cast<std::ptrdiff_t>(first),
                unresolved.begin() + static_cast<std::ptrdiff_t>(last), true);
  }
  return unresolved;
}

} // namespace

CurveGaps gaps_of(const std::vector<double> &y, const std::vector<std::vector<double>> &spins)
{
  CurveGaps gaps = { jumps_of(y) };
  for (const std::vector<double> &spin : spins)
  {
    const std::vector<bool> jumps = jumps_of(spin), unresolved = unresolved_changes_of_sign(spin);
    for (std::size_t i = 0; i < gaps.at.size(); ++i)
      gaps.at[i] = gaps.at[i] || jumps[i] || unresolved[i];
    gaps.hides_change_of_sign =
      gaps.hides_change_of_sign || std::find(unresolved.begin(), unresolved.end(), true) != unresolved.end();
  }
  return gaps;
}

} // namespace stemware::pipeline
