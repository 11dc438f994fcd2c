#pragma once

#include <vector>

/// Between which values of a curve no line may be drawn: entry i of what is returned stands for the interval
/// from value i to value i + 1. Values that are not a number are those of cases that have failed.
namespace stemware::pipeline
{

/// Intervals between the values of a curve in which it jumps: one of them, or two side by side, over which
/// the curve changes more than four times as much as over those to their left and right.
std::vector<bool> jumps_of(const std::vector<double> &y);

/// Intervals in which a spin changes its sign, together with the values between that are zero, where they are
/// too wide to tell how: the curve changes more than four times as much there as over the intervals beside,
/// or there are none beside.
std::vector<bool> unresolved_changes_of_sign(const std::vector<double> &y);

struct CurveGaps
{
  std::vector<bool> at; ///< the intervals
  bool hides_change_of_sign = false;
};

/// The jumps of a curve, and of the @p spins that it shows or is computed from, with the changes of sign of
/// those.
CurveGaps gaps_of(const std::vector<double> &y, const std::vector<std::vector<double>> &spins);

} // namespace stemware::pipeline
