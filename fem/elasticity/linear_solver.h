#pragma once

namespace stemware::fem
{

/// Linear solver of a three-dimensional body: condensation to the contact nodes, or conjugate gradients
/// with a preconditioner.
enum class LinearSolver
{
  automatic, ///< condensed to the contact nodes where SolidFoot can; else multigrid or, if small, direct
  direct,    ///< factorisation (MUMPS) of a recent tangent
  multigrid  ///< over the meshes that the body's was refined from and its mean body of revolution
             ///< (MeshHierarchy)
};

/// Number of unknowns above which multigrid needs less time and memory than a factorisation
/// (docs/method/solid_measurements.md, "Small feet").
constexpr unsigned int max_direct_unknowns = 5000;

/// Number of unknowns above which no body is condensed to its contact nodes: the factorisation takes about 25
/// kB per unknown.
constexpr unsigned int max_condensed_unknowns = 60000;

} // namespace stemware::fem
