#pragma once

#include "fem/solid/level_matrix.h"

namespace stemware::fem
{

/// Approximate inverse of K + B' T B on the coarsest level.
class CoarseSolver : public dealii::MGCoarseGridBase<FloatVector>
{
public:
  /// @p tangent T between the contact nodes, this rank's part of it, which operator() then knows. Throws
  /// std::runtime_error when the sum is not positive definite.
  virtual void set_contact(const Eigen::SparseMatrix<double> &tangent) = 0;
};

/// Inverse, factorised on every rank, where the level is small; else a two-grid cycle: Chebyshev
/// smoothing before and after a correction by the body of revolution that the mesh is on average
/// (AxisymmetricCoarseSpace). Both are symmetric.
///
/// Keeps a reference to @p matrix, that of @p level, whose contact is set before this one's; @p nodes:
/// contact nodes of the level.
std::unique_ptr<CoarseSolver> make_coarse_solver(const SolidLevel &level, const LevelMatrix &matrix,
                                                 const ElasticMaterial &material,
                                                 const std::shared_ptr<const ContactNodes> &nodes);

} // namespace stemware::fem
