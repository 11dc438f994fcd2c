#pragma once

#include <Eigen/Core>

namespace stemware::pipeline
{

/// Equidistant nodes over one period of an angle, with the trigonometric interpolation between them. One node
/// stands for a function that does not depend on the angle.
class PeriodicGrid
{
public:
  /// @p period > 0 [rad]; @p n_nodes is 1 or even.
  PeriodicGrid(double period, unsigned int n_nodes);

  unsigned int size() const { return n_nodes; }
  double node(unsigned int i) const { return period * i / n_nodes; }
  double step() const { return period / n_nodes; }
  PeriodicGrid refined() const { return PeriodicGrid(period, 2 * n_nodes); }
  /// With half the nodes; one remains one.
  PeriodicGrid halved() const;
  /// Weights of the nodes' values in the interpolant at @p angle. Shape [size()].
  Eigen::VectorXd weights(double angle) const;

private:
  double period;
  unsigned int n_nodes;
};

} // namespace stemware::pipeline
