#pragma once

#include <Eigen/Core>

namespace stemware::ring
{
/// Returns the values at @p x of the Lagrange polynomials of @p nodes. Shape [nodes.size()].
inline Eigen::VectorXd lagrange_values(const Eigen::VectorXd &nodes, double x)
{
  Eigen::VectorXd values = Eigen::VectorXd::Ones(nodes.size());
  for (Eigen::Index i = 0; i < nodes.size(); ++i)
    for (Eigen::Index k = 0; k < nodes.size(); ++k)
      if (k != i)
        values(i) *= (x - nodes(k)) / (nodes(i) - nodes(k));
  return values;
}
} // namespace stemware::ring
