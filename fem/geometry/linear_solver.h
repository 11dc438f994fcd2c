#pragma once

namespace stemware::fem
{

/// Linear solver of a three-dimensional body.
enum class LinearSolver
{
  automatic, ///< condensed if SolidFoot can, else multigrid
  condensed, ///< contacts are solved on the compliance between the contact nodes; one rank
  multigrid  ///< conjugate gradients, preconditioned over the meshes that the body's was refined from
             ///< (MeshHierarchy)
};

/// Number of unknowns above which no body is condensed to its contact nodes: the factorisation takes about 25
/// kB per unknown.
constexpr unsigned int max_condensed_unknowns = 60000;

} // namespace stemware::fem
