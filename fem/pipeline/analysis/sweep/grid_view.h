#pragma once

#include "fem/pipeline/analysis/sweep/sweep_plan.h"

#include <cstddef>
#include <vector>

/// How the cases of a grid are drawn.
namespace stemware::pipeline
{

/// Roles of the entries of a grid in its pictures: curves over one entry of numbers, one of them for each
/// word or each of a few values of the other; maps over both where those are many.
struct GridView
{
  explicit GridView(const SweepPlan &plan);

  /// Values of one curve, of the @p values of all cases.
  std::vector<double> curve(const std::vector<double> &values, std::size_t number) const;

  std::size_t along = 0;    ///< the entry along the axis of curves
  std::size_t n_along = 0;  ///< its values
  std::size_t n_curves = 1; ///< values of the other entry
  bool has_two = false;     ///< entries; the other one is 1 - along
  bool is_map = false;
  bool can_be_drawn = false; ///< else both entries are words

private:
  std::size_t step = 1; ///< from one value along the axis to the next, in cases
};

/// Where a curve has gaps: no line may be drawn there.
struct CurveGaps
{
  std::vector<bool> at; ///< entry i: in the interval from value i to value i + 1
  bool hides_change_of_sign = false;
};

/// Gaps of a curve: where it jumps, where one of the @p spins does that it shows or is computed from, and
/// where such a spin changes its sign unresolved. Values that are not a number are those of failed cases.
CurveGaps gaps_of(const std::vector<double> &y, const std::vector<std::vector<double>> &spins);

} // namespace stemware::pipeline
