#pragma once

#include <Eigen/Core>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

/// Check of a derivative by the remainder r(h) = |f(x + h d) - f(x) - h f'(x) d|, which decreases like h^2
/// (or faster) for the derivative of f and like h for any other value.
namespace stemware::taylor
{

inline double size_of(double value)
{
  return std::abs(value);
}
inline double size_of(const Eigen::VectorXd &value)
{
  return value.norm();
}

/// Returns the slope of log r over log h, fitted to the four smallest of twelve halved steps whose r exceeds
/// the rounding error; infinite if no r does (linear f), NaN if fewer than four do. @p function returns f(x +
/// h d) for a step h, @p derivative is f'(x) d, @p step the largest step, @p noise the relative rounding
/// error of f.
template <typename Function, typename Value>
double slope_of_remainder(const Function &function, const Value &derivative, double step, double noise)
{
  constexpr unsigned int n_steps = 12, n_fitted = 4;
  const Value here = function(0.);
  std::vector<Eigen::Vector2d> logarithms;
  for (unsigned int k = 0; k < n_steps; ++k, step /= 2)
  {
    const Value there = function(step);
    const double remainder = size_of(Value(there - here - step * derivative));
    if (!(remainder <= 20 * noise * std::max(size_of(here), size_of(there)))) // true for NaN
      logarithms.emplace_back(std::log(step), std::log(remainder));
  }
  if (logarithms.empty())
    return std::numeric_limits<double>::infinity();
  if (logarithms.size() < n_fitted)
    return std::numeric_limits<double>::quiet_NaN();
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (unsigned int i = 0; i < n_fitted; ++i)
    mean += logarithms[logarithms.size() - 1 - i] / n_fitted;
  double above = 0, below = 0;
  for (unsigned int i = 0; i < n_fitted; ++i)
  {
    const Eigen::Vector2d away = logarithms[logarithms.size() - 1 - i] - mean;
    above += away(0) * away(1);
    below += away(0) * away(0);
  }
  return above / below;
}

/// Returns success if the slope of the remainder exceeds 1.85. Arguments as in slope_of_remainder().
template <typename Function, typename Value>
testing::AssertionResult is_derivative(const Function &function, const Value &derivative, double step,
                                       double noise = 1e-15)
{
  const double slope = slope_of_remainder(function, derivative, step, noise);
  if (slope > 1.85)
    return testing::AssertionSuccess();
  return testing::AssertionFailure() << "the remainder of Taylor's formula has the slope " << slope
                                     << "; 2 is that of a derivative. Steps from " << step << " down.";
}

} // namespace stemware::taylor
