#pragma once

namespace stemware::fem
{

/// Linear solver of a three-dimensional body.
enum class LinearSolver
{
  automatic, ///< condensed if SolidFoot can, else multigrid
  condensed, ///< contacts are solved on the compliance between the contact nodes; one rank
  multigrid  ///< conjugate gradients with a multigrid preconditioner on the mesh hierarchy of the body
             ///< (MeshHierarchy)
};

/// Maximum number of unknowns of a body that is condensed to its contact nodes. The factorisation needs about
/// 25 kB per unknown.
constexpr unsigned int max_condensed_unknowns = 60000;

} // namespace stemware::fem
