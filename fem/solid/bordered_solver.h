#pragma once

#include "fem/solid/solid_body.h"

#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <deal.II/lac/trilinos_vector.h>

#include <Eigen/Core>

#include <array>
#include <memory>
#include <optional>

namespace stemware::fem
{

/// Factors of a tangent stiffness, by MUMPS.
class Factorization;

/// A tangent stiffness bordered by the table motions and the conditions on the forces: [A, G; H', C], A
/// symmetric positive definite, and the whole of it too where H = G.
struct BorderedSystem
{
  const dealii::TrilinosWrappers::SparseMatrix &matrix;        ///< A
  std::array<dealii::TrilinosWrappers::MPI::Vector, 3> border; ///< columns of G
  /// Columns of H; none where H = G.
  std::optional<std::array<dealii::TrilinosWrappers::MPI::Vector, 3>> condition_border;
  Eigen::Matrix3d corner; ///< C
};

/// A right-hand side or solution of a BorderedSystem.
struct BorderedVector
{
  dealii::TrilinosWrappers::MPI::Vector body;
  Eigen::Vector3d motion = Eigen::Vector3d::Zero(); ///< the same on every rank
};

/// Conjugate gradients for bordered systems, preconditioned by factors of A that are kept between systems
/// that differ little.
class BorderedSolver
{
public:
  BorderedSolver();
  ~BorderedSolver();

  /// Solves to a residual of @p reduction times that of zero, by the Schur complement where the system is
  /// unsymmetric; returns the number of iterations. @p is_same: the system is that of the call before. Throws
  /// std::runtime_error when A cannot be factorised, or 2000 iterations do not do.
  unsigned int solve(const BorderedSystem &system, const BorderedVector &rhs, double reduction,
                     BorderedVector &solution, bool is_same = false);

  /// C - H' A^-1 G of the unsymmetric system solved last.
  const Eigen::Matrix3d &schur_complement() const { return schur; }

private:
  void build_preconditioner(const BorderedSystem &system);
  unsigned int solve_symmetric(const BorderedSystem &system, const BorderedVector &rhs, double reduction,
                               BorderedVector &solution) const;
  unsigned int solve_by_schur_complement(const BorderedSystem &system, const BorderedVector &rhs,
                                         double reduction, BorderedVector &solution, bool is_same);
  unsigned int solve_body(const dealii::TrilinosWrappers::SparseMatrix &matrix,
                          const dealii::TrilinosWrappers::MPI::Vector &rhs, double reduction,
                          dealii::TrilinosWrappers::MPI::Vector &solution) const;

  std::unique_ptr<const Factorization> preconditioner;
  /// A^-1 G of the system it was built for.
  std::array<dealii::TrilinosWrappers::MPI::Vector, 3> eliminated_border;
  Eigen::Matrix3d inverse_schur = Eigen::Matrix3d::Identity();
  /// A^-1 G of the unsymmetric system solved last.
  std::array<dealii::TrilinosWrappers::MPI::Vector, 3> columns;
  Eigen::Matrix3d schur = Eigen::Matrix3d::Identity();
};

} // namespace stemware::fem
