#pragma once

#include "fem/solid/level_matrix.h"

namespace stemware::fem
{

/// Approximate inverse of K + B' T B on the coarsest level.
class CoarseSolver : public dealii::MGCoarseGridBase<FloatVector>
{
public:
  /// Sets @p tangent T of the contact nodes (this rank's part) for operator(). Throws std::runtime_error if
  /// the sum is not positive definite.
  virtual void set_contact(const Eigen::SparseMatrix<double> &tangent) = 0;
};

/// Makes the solver: factors on every rank if the level is small; else a two-grid cycle, Chebyshev smoothing
/// before and after a correction in the axisymmetric coarse space. Both are symmetric.
///
/// Keeps a reference to @p matrix, the matrix of @p level; its contact is set before that of the solver. @p
/// nodes: contact nodes of the level.
std::unique_ptr<CoarseSolver> make_coarse_solver(const SolidLevel &level, const LevelMatrix &matrix,
                                                 const ElasticMaterial &material,
                                                 const std::shared_ptr<const ContactNodes> &nodes);

} // namespace stemware::fem
