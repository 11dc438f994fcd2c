#pragma once

#include "fem/solid/solid_body.h"

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <deal.II/lac/trilinos_vector.h>

#include <Eigen/Core>

#include <array>
#include <memory>
#include <optional>

namespace stemware::fem
{

/// The six rigid-body motions of an elastic body as vectors: what an algebraic multigrid method must know to
/// coarsen elasticity.
class RigidBodyModes
{
public:
  /// Translations and rotations at the dofs' support points, zero at constrained dofs.
  RigidBodyModes(const dealii::Mapping<3> &mapping, const dealii::DoFHandler<3> &dof_handler,
                 const dealii::AffineConstraints<double> &constraints);
  static constexpr unsigned int n_modes = 6;
  /// Contiguous values of mode after mode at the locally owned dofs, in their order.
  std::vector<double> values;
};

/// Approximate inverse of a tangent stiffness, fixed until it is built anew.
class TangentPreconditioner
{
public:
  virtual ~TangentPreconditioner() = default;
  virtual void vmult(dealii::TrilinosWrappers::MPI::Vector &dst,
                     const dealii::TrilinosWrappers::MPI::Vector &src) const = 0;
  /// Iterations of conjugate gradients above which building it anew pays.
  virtual unsigned int patience() const = 0;
};

/// Factorisation by MUMPS. Throws std::runtime_error when it fails.
std::unique_ptr<TangentPreconditioner> factorize(const dealii::TrilinosWrappers::SparseMatrix &matrix);

/// Smoothed-aggregation multigrid (ML) whose near-null space is @p modes; @p quadratic elements need a
/// stronger smoother.
std::unique_ptr<TangentPreconditioner> make_multigrid(const dealii::TrilinosWrappers::SparseMatrix &matrix,
                                                      const RigidBodyModes &modes, bool quadratic);

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

/// Preconditioned conjugate gradients for bordered systems; keeps its preconditioner between systems that
/// differ little.
class BorderedSolver
{
public:
  /// @p make builds a preconditioner of A.
  using MakePreconditioner =
    std::function<std::unique_ptr<TangentPreconditioner>(const dealii::TrilinosWrappers::SparseMatrix &)>;
  explicit BorderedSolver(MakePreconditioner make)
      : make(std::move(make))
  {
  }

  /// Solves to a residual of @p reduction times that of zero, by the Schur complement where the system is
  /// unsymmetric; returns the number of iterations. @p is_same: the system is that of the call before. Throws
  /// std::runtime_error when 2000 iterations do not do.
  unsigned int solve(const BorderedSystem &system, const BorderedVector &rhs, double reduction,
                     BorderedVector &solution, bool is_same = false);

private:
  void build_preconditioner(const BorderedSystem &system);
  unsigned int solve_symmetric(const BorderedSystem &system, const BorderedVector &rhs, double reduction,
                               BorderedVector &solution) const;
  unsigned int solve_by_schur_complement(const BorderedSystem &system, const BorderedVector &rhs,
                                         double reduction, BorderedVector &solution, bool is_same);
  unsigned int solve_body(const dealii::TrilinosWrappers::SparseMatrix &matrix,
                          const dealii::TrilinosWrappers::MPI::Vector &rhs, double reduction,
                          dealii::TrilinosWrappers::MPI::Vector &solution) const;

  MakePreconditioner make;
  std::unique_ptr<TangentPreconditioner> preconditioner;
  /// A^-1 G of the system it was built for.
  std::array<dealii::TrilinosWrappers::MPI::Vector, 3> eliminated_border;
  Eigen::Matrix3d inverse_schur = Eigen::Matrix3d::Identity();
  /// A^-1 G of the unsymmetric system solved last.
  std::array<dealii::TrilinosWrappers::MPI::Vector, 3> columns;
};

} // namespace stemware::fem
