#pragma once

#include "fem/solid/level_matrix.h"

#include <deal.II/lac/trilinos_precondition.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <vector>

namespace stemware::fem
{

/// Approximate inverse of K + B' T B on the coarsest level: a two-grid cycle, Chebyshev smoothing before and
/// after a correction by coarse_preconditioner(). Symmetric and positive definite.
///
/// Matrix and preconditioner are set up by the first set_contact(), and again when T has changed much.
class CoarseSolver : public dealii::MGCoarseGridBase<FloatVector>
{
public:
  /// Keeps references to @p level and to @p matrix, the matrix of this level. The contact of @p matrix must
  /// be set first. @p nodes: contact nodes of the level.
  CoarseSolver(const SolidLevel &level, const LevelMatrix &matrix, const ElasticMaterial &material,
               const std::shared_ptr<const ContactNodes> &nodes);

  /// Sets @p tangent T of the contact nodes (this rank's part) for operator().
  void set_contact(const Eigen::SparseMatrix<double> &tangent);

  void operator()(unsigned int level, FloatVector &dst, const FloatVector &src) const override;

private:
  using Vector = dealii::LinearAlgebra::distributed::Vector<double>;

  const SolidLevel &level;
  const LevelMatrix &matrix;
  const ElasticMaterial material;
  const std::shared_ptr<const ContactNodes> nodes;
  LevelSmoother smoother;

  dealii::TrilinosWrappers::SparseMatrix stiffness; ///< K
  std::vector<double> modes;                        ///< rigid motions
  Eigen::SparseMatrix<double> aggregated;           ///< T in `sum`
  dealii::TrilinosWrappers::SparseMatrix sum;       ///< K + B' T B
  std::unique_ptr<dealii::TrilinosWrappers::PreconditionAMG> correction;
  mutable Vector residual, solution; ///< work space of operator()
};

} // namespace stemware::fem
