#include "fem/pipeline/coupling/periodic_grid.h"

#include <boost/math/constants/constants.hpp>

#include <cmath>
#include <stdexcept>

namespace stemware::pipeline
{

PeriodicGrid::PeriodicGrid(double period, unsigned int n_nodes)
    : period(period)
    , n_nodes(n_nodes)
{
  if (!(period > 0) || n_nodes == 0 || (n_nodes > 1 && n_nodes % 2 == 1))
    throw std::logic_error("a periodic grid has a positive period and one or an even number of nodes");
}

PeriodicGrid PeriodicGrid::halved() const
{
  return PeriodicGrid(period, n_nodes > 1 ? n_nodes / 2 : 1);
}

Eigen::VectorXd PeriodicGrid::weights(double angle) const
{
  if (n_nodes == 1)
    return Eigen::VectorXd::Ones(1);
  // Barycentric form for an even number of nodes: (-1)^i cot((x - x_i) / 2).
  Eigen::VectorXd values(n_nodes);
  for (unsigned int i = 0; i < n_nodes; ++i)
  {
    const double half = boost::math::double_constants::pi * (angle - node(i)) / period;
    const double sine = std::sin(half);
    if (std::abs(sine) < 1e-14)
      return Eigen::VectorXd::Unit(n_nodes, i);
    values(i) = (i % 2 == 0 ? 1 : -1) * std::cos(half) / sine;
  }
  return values / values.sum();
}

} // namespace stemware::pipeline
