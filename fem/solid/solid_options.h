#pragma once

#include "fem/geometry/linear_solver.h"

namespace stemware::fem
{

/// Numerical parameters of a SolidBody.
struct SolidOptions
{
  unsigned int degree = 2; ///< polynomial degree of elements and of their geometry: 1 or 2
  LinearSolver linear_solver = LinearSolver::automatic;
  bool straight_edges = false; ///< geometry of degree 1 whatever the element (meshes without a round rim)
  /// Contact lines of a face, over the default.
  unsigned int line_factor = 1;
};

} // namespace stemware::fem
