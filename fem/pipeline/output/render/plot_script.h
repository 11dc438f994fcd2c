#pragma once

#include "fem/pipeline/output/render/curve_plot.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace stemware::pipeline
{

/// Least and largest of numbers, those that are not finite left out; the first is larger where there are
/// none.
struct Extent
{
  double least = std::numeric_limits<double>::infinity(), most = -least;

  void include(double value)
  {
    if (!std::isfinite(value))
      return;
    least = std::min(least, value);
    most = std::max(most, value);
  }
};

/// gnuplot's commands for the axis "x" or "y".
std::string axis_commands(const std::string &which, const Axis &axis);

/// gnuplot's commands for at most five tics of the linear axis "x", "y" or "cb" between @p low and @p high,
/// with the decimals that tell them apart: gnuplot itself lets long labels overlap.
std::string tic_commands(const std::string &which, double low, double high);

/// gnuplot's commands for a colour scale from @p low to @p high with its label.
std::string colour_commands(const std::string &label, double low, double high);

} // namespace stemware::pipeline
