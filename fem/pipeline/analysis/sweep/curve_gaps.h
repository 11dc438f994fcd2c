#pragma once

#include <vector>

/// Between which values of a curve no line may be drawn: entry i of what is returned stands for the interval
/// from value i to value i + 1. Values that are not a number are those of cases that have failed.
namespace stemware::pipeline
{

/// Where a curve has gaps.
struct CurveGaps
{
  std::vector<bool> at; ///< the intervals
  bool hides_change_of_sign = false;
};

/// Gaps of a curve: where it jumps, where one of the @p spins does that it shows or is computed from, and
/// where such a spin changes its sign unresolved.
CurveGaps gaps_of(const std::vector<double> &y, const std::vector<std::vector<double>> &spins);

} // namespace stemware::pipeline
