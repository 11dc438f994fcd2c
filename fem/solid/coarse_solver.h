#pragma once

#include "fem/solid/contact_nodes.h"
#include "fem/solid/simd/elastic_operator.h"
#include "fem/solid/solid_level.h"

#include <deal.II/lac/diagonal_matrix.h>
#include <deal.II/lac/precondition.h>
#include <deal.II/lac/trilinos_precondition.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <deal.II/multigrid/mg_base.h>

#include <vector>

namespace stemware::fem
{

/// Vector of the V-cycle, in single precision.
using FloatVector = dealii::LinearAlgebra::distributed::Vector<float>;

/// K + B' T B on one level in single precision, with the interface of deal.II's smoothers.
class LevelMatrix : public dealii::Subscriptor
{
public:
  using value_type = float;
  using size_type = dealii::types::global_dof_index;

  /// @p nodes: contact nodes of the level.
  void reinit(const SolidLevel &level, const ElasticMaterial &material,
              const std::shared_ptr<const ContactNodes> &nodes);
  /// Sets @p tangent T of the contact nodes, this rank's part.
  void set_contact(const Eigen::SparseMatrix<double> &tangent);

  void vmult(FloatVector &dst, const FloatVector &src) const;
  void Tvmult(FloatVector &dst, const FloatVector &src) const { vmult(dst, src); }
  size_type m() const { return elastic_diagonal.size(); }
  size_type n() const { return m(); }
  /// Throws: the matrix has no stored entries.
  float el(size_type, size_type) const;

  void initialize_dof_vector(FloatVector &vector) const { elastic->initialize_dof_vector(vector); }
  /// Returns the inverse diagonal, updated by set_contact().
  const std::shared_ptr<dealii::DiagonalMatrix<FloatVector>> &jacobi() const { return inverse_diagonal; }

private:
  std::unique_ptr<ElasticOperator<float>> elastic;
  std::unique_ptr<ContactStiffness> contact;
  FloatVector elastic_diagonal;
  std::shared_ptr<dealii::DiagonalMatrix<FloatVector>> inverse_diagonal;
};

/// Chebyshev polynomial of the Jacobi-scaled operator.
using LevelSmoother =
  dealii::PreconditionChebyshev<LevelMatrix, FloatVector, dealii::DiagonalMatrix<FloatVector>>;

/// Returns the options of the smoother of every level (docs/method/solid_measurements.md).
LevelSmoother::AdditionalData smoothing_of(const LevelMatrix &matrix);

/// Approximate inverse of K + B' T B on the coarsest level, symmetric and positive definite: Chebyshev
/// smoothing before and after a correction by algebraic multigrid. Set up by the first set_contact(), and
/// again when T has changed much.
class CoarseSolver : public dealii::MGCoarseGridBase<FloatVector>
{
public:
  /// Keeps references to @p level and its @p matrix, whose contact must be set. @p nodes: those of @p level.
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
