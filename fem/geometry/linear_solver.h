#pragma once

namespace stemware::fem
{

/// Linear solver of a three-dimensional body.
enum class LinearSolver
{
  automatic, ///< condensed if SolidFoot can, else multigrid
  condensed, ///< contacts are solved on the compliance between the contact nodes; one rank
  multigrid  ///< conjugate gradients, preconditioned by multigrid (MeshHierarchy)
};

/// Maximum number of unknowns of a condensed body. The factorisation needs about 25 kB per unknown.
constexpr unsigned int max_condensed_unknowns = 60000;

} // namespace stemware::fem
