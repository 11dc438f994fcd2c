#include "fem/pipeline/analysis/sweep/grid_view.h"

#include <algorithm>
#include <cmath>

namespace stemware::pipeline
{

namespace
{

constexpr double factor = 4; ///< "much" for a jump

/// How much a curve changes from each value to the next.
std::vector<double> steps_of(const std::vector<double> &y)
{
  std::vector<double> steps;
  for (std::size_t i = 0; i + 1 < y.size(); ++i)
    steps.push_back(std::abs(y[i + 1] - y[i]));
  return steps;
}

/// Marks the intervals in which a curve jumps: one of them, or two side by side, over which it changes more
/// than four times as much as over those to their left and right.
void mark_jumps(const std::vector<double> &y, std::vector<bool> &marks)
{
  const std::vector<double> steps = steps_of(y);
  for (const std::ptrdiff_t width : { 1, 2 })
    for (auto left = steps.begin(); steps.end() - left > width + 1; ++left)
    {
      const auto right = left + width + 1;
      if (!std::all_of(left, right + 1, [](double step) { return std::isfinite(step); }))
        continue; // beside a case that has failed
      const double smallest = *std::min_element(left + 1, right), beside = std::max(*left, *right);
      if (smallest > factor * beside && beside > 1e-9 * smallest) // rounding beside a step tells nothing
        std::fill_n(marks.begin() + (left + 1 - steps.begin()), width, true);
    }
}

/// Marks the intervals in which a spin changes its sign, together with the values between that are zero,
/// where they are too wide to tell how: the curve changes more than four times as much there as over the
/// intervals beside, or there are none beside. Returns whether there are some.
bool mark_unresolved_changes_of_sign(const std::vector<double> &y, std::vector<bool> &marks)
{
  const std::vector<double> steps = steps_of(y);
  double largest = 0;
  for (const double value : y)
    largest = std::fmax(largest, std::abs(value)); // of the numbers among them
  const auto is_zero = [&](std::size_t i) { return std::abs(y[i]) <= 1e-9 * largest; };
  const auto beside = [&](std::size_t i)
  { return i < steps.size() && std::isfinite(steps[i]) ? steps[i] : 0; };
  bool has_some = false;
  for (std::size_t first = 0; first < steps.size(); ++first)
  {
    std::size_t last = first + 1;
    while (last < steps.size() && is_zero(last))
      ++last;
    if (is_zero(first) || !(y[first] * y[last] < 0))
      continue;
    const auto from = steps.begin() + static_cast<std::ptrdiff_t>(first);
    const auto width = static_cast<std::ptrdiff_t>(last - first);
    if (*std::min_element(from, from + width) <= factor * std::max(beside(first - 1), beside(last)))
      continue;
    std::fill_n(marks.begin() + static_cast<std::ptrdiff_t>(first), width, true);
    has_some = true;
  }
  return has_some;
}

bool is_numeric(const SweptEntry &entry)
{
  return !entry.unit.empty() && entry.values.size() > 1;
}

} // namespace

GridView::GridView(const SweepPlan &plan)
    : has_two(plan.entries.size() == 2)
{
  constexpr std::size_t most_curves = 7, least_of_map = 4;
  const SweptEntry &first = plan.entries.front(), &last = plan.entries.back();
  const std::size_t n_first = first.values.size(), n_last = last.values.size();
  const bool are_numeric = is_numeric(first) && is_numeric(last);
  if (has_two && (!is_numeric(first) || (are_numeric && n_first <= most_curves && n_first < n_last)))
    along = 1;
  can_be_drawn = is_numeric(plan.entries[along]);
  n_along = along == 0 ? n_first : n_last;
  if (!has_two)
    return;
  n_curves = along == 0 ? n_last : n_first;
  step = along == 0 ? n_last : 1;
  is_map = are_numeric && (n_curves > most_curves || std::min(n_first, n_last) >= least_of_map);
}

std::vector<double> GridView::curve(const std::vector<double> &values, std::size_t number) const
{
  const std::size_t first = number * (along == 0 ? 1 : n_along);
  std::vector<double> curve;
  for (std::size_t i = 0; i < n_along; ++i)
    curve.push_back(values[first + i * step]);
  return curve;
}

CurveGaps gaps_of(const std::vector<double> &y, const std::vector<std::vector<double>> &spins)
{
  CurveGaps gaps = { std::vector<bool>(y.size()) };
  mark_jumps(y, gaps.at);
  for (const std::vector<double> &spin : spins)
  {
    mark_jumps(spin, gaps.at);
    gaps.hides_change_of_sign |= mark_unresolved_changes_of_sign(spin, gaps.at);
  }
  return gaps;
}

} // namespace stemware::pipeline
