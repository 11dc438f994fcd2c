#pragma once

#include <Eigen/Core>

#include <vector>

namespace stemware::pipeline
{

/// Chebyshev points on an interval of spins, both ends included, with the polynomial interpolation between
/// them.
class SpinInterval
{
public:
  /// n_steps + 1 points on [lower, upper] [rad/s].
  SpinInterval(double lower, double upper, unsigned int n_steps);

  unsigned int size() const { return n_steps + 1; }
  double node(unsigned int i) const { return at(i); }
  std::vector<double> nodes() const;
  /// Weights of the nodes' values in the interpolant at @p omega. Shape [size()].
  Eigen::VectorXd weights(double omega) const;

  /// The points halfway between the nodes: what refined() adds.
  std::vector<double> between() const;
  SpinInterval refined() const { return SpinInterval(lower, upper, 2 * n_steps); }

private:
  double at(double place) const;

  double lower, upper;
  unsigned int n_steps;
};

} // namespace stemware::pipeline
