#pragma once

namespace stemware::fem
{

/// Preconditioner of the linear systems of a three-dimensional body; the outer method is always conjugate
/// gradients.
enum class LinearSolver
{
  automatic, ///< multigrid on refined meshes and above max_direct_unknowns unknowns, else direct
  direct,    ///< factorisation (MUMPS) of a recent tangent
  multigrid  ///< over the meshes that the body's was refined from and its mean body of revolution
             ///< (MeshHierarchy)
};

/// Number of unknowns above which multigrid needs less time and memory than a factorisation
/// (docs/method/solid_measurements.md, "Small feet").
constexpr unsigned int max_direct_unknowns = 5000;

} // namespace stemware::fem
