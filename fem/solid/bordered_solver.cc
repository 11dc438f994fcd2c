#include "fem/solid/bordered_solver.h"

#include "fem/contact/contact_solution.h"
#include "fem/solid/conjugate_gradients.h"

#include <deal.II/base/mpi.h>
#include <deal.II/lac/trilinos_parallel_block_vector.h>
#include <deal.II/lac/trilinos_solver.h>

#include <Eigen/LU>

#include <iostream>
#include <stdexcept>

namespace stemware::fem
{

using namespace dealii;
using VectorType = TrilinosWrappers::MPI::Vector;
using MatrixType = TrilinosWrappers::SparseMatrix;

namespace
{
constexpr unsigned int max_iterations = 2000;

/// Iterations above which new factors pay: a back substitution costs about a sixtieth of a factorisation.
constexpr unsigned int patience = 30;
} // namespace

class Factorization
{
public:
  explicit Factorization(const MatrixType &matrix)
      : solver(control, TrilinosWrappers::SolverDirect::AdditionalData(false, "Amesos_Mumps"))
  {
    // Amesos prints what MUMPS says; the exception says it in the words of a study.
    std::streambuf *const printed = std::cerr.rdbuf(nullptr);
    bool has_failed = false;
    try
    {
      solver.initialize(matrix);
    }
    catch (const ExceptionBase &)
    {
      has_failed = true;
    }
    std::cerr.rdbuf(printed);
    if (has_failed)
      throw ContactFailure(
        ContactOutcome::linear_solver_failed,
        "The stiffness of " + std::to_string(matrix.m()) +
          " unknowns cannot be factorised: cells are distorted or memory is short; mend the "
          "mesh, use fewer cells, or set Contact/Linear solver = multigrid.");
  }
  void vmult(VectorType &dst, const VectorType &src) const { solver.solve(dst, src); }

private:
  SolverControl control;
  mutable TrilinosWrappers::SolverDirect solver; // solve() is not const in deal.II, though it changes nothing
};

namespace
{

/// What deal.II's conjugate gradients need of a vector, for a BorderedVector: body dofs on their ranks,
/// motions on rank 0.
using BlockVector = TrilinosWrappers::MPI::BlockVector;

BlockVector to_block(const BorderedVector &vector)
{
  const MPI_Comm &communicator = vector.body.get_mpi_communicator();
  IndexSet motion_dofs(3);
  if (Utilities::MPI::this_mpi_process(communicator) == 0)
    motion_dofs.add_range(0, 3);
  BlockVector result(std::vector<IndexSet>{ vector.body.locally_owned_elements(), motion_dofs },
                     communicator);
  result.block(0) = vector.body;
  for (const auto i : motion_dofs)
    result.block(1)(i) = vector.motion(static_cast<Eigen::Index>(i));
  result.block(1).compress(VectorOperation::insert);
  return result;
}

Eigen::Vector3d motion_of(const BlockVector &vector)
{
  std::array<double, 3> values{};
  for (const auto i : vector.block(1).locally_owned_elements())
    values[i] = vector.block(1)(i);
  values = Utilities::MPI::broadcast(vector.block(0).get_mpi_communicator(), values, 0);
  return { values[0], values[1], values[2] };
}

void set_motion(BlockVector &vector, const Eigen::Vector3d &motion)
{
  for (const auto i : vector.block(1).locally_owned_elements())
    vector.block(1)(i) = motion(static_cast<Eigen::Index>(i));
  vector.block(1).compress(VectorOperation::insert);
}

Eigen::Vector3d products(const std::array<VectorType, 3> &columns, const VectorType &vector)
{
  return { columns[0] * vector, columns[1] * vector, columns[2] * vector };
}

struct BorderedOperator
{
  const BorderedSystem &system;
  void vmult(BlockVector &dst, const BlockVector &src) const
  {
    const Eigen::Vector3d motion = motion_of(src);
    system.matrix.vmult(dst.block(0), src.block(0));
    for (unsigned int i = 0; i < 3; ++i)
      dst.block(0).add(motion(i), system.border[i]);
    set_motion(dst, products(system.border, src.block(0)) + system.corner * motion);
  }
};

/// Block elimination of the border with an approximate inverse of A: symmetric and positive definite whenever
/// that one is.
struct BorderedPreconditioner
{
  const Factorization &inner;
  const std::array<VectorType, 3> &eliminated_border;
  const Eigen::Matrix3d &inverse_schur;
  void vmult(BlockVector &dst, const BlockVector &src) const
  {
    const Eigen::Vector3d motion =
      inverse_schur * (motion_of(src) - products(eliminated_border, src.block(0)));
    inner.vmult(dst.block(0), src.block(0));
    for (unsigned int i = 0; i < 3; ++i)
      dst.block(0).add(-motion(i), eliminated_border[i]);
    set_motion(dst, motion);
  }
};

/// To a residual of @p reduction times that of no solution.
template <typename Vector, typename Operator, typename Preconditioner>
unsigned int reduce_residual(const Operator &system, const Preconditioner &preconditioner, const Vector &rhs,
                             double reduction, Vector &solution)
{
  const double rhs_norm = rhs.l2_norm();
  if (rhs_norm == 0)
  {
    solution = 0;
    return 0;
  }
  return conjugate_gradients(system, preconditioner, rhs, reduction * rhs_norm, max_iterations, solution);
}

} // namespace

BorderedSolver::BorderedSolver() = default;
BorderedSolver::~BorderedSolver() = default;

unsigned int BorderedSolver::solve_body(const MatrixType &matrix, const VectorType &rhs, double reduction,
                                        VectorType &solution) const
{
  return reduce_residual(matrix, *preconditioner, rhs, reduction, solution);
}

void BorderedSolver::build_preconditioner(const BorderedSystem &system)
{
  preconditioner.reset(); // before the new one asks for memory
  preconditioner = std::make_unique<const Factorization>(system.matrix);
  // The Schur complement of an inexact elimination W, in the form (-W, 1)' M (-W, 1) that stays positive
  // definite.
  Eigen::Matrix3d symmetric = system.corner;
  std::array<VectorType, 3> images;
  for (unsigned int i = 0; i < 3; ++i)
  {
    eliminated_border[i].reinit(system.border[i]);
    images[i].reinit(system.border[i]);
    solve_body(system.matrix, system.border[i], 1e-4, eliminated_border[i]);
    system.matrix.vmult(images[i], eliminated_border[i]);
  }
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < 3; ++j)
      symmetric(i, j) += eliminated_border[i] * images[j] - eliminated_border[i] * system.border[j] -
                         system.border[i] * eliminated_border[j];
  inverse_schur = ((symmetric + symmetric.transpose()) / 2).inverse();
}

unsigned int BorderedSolver::solve_symmetric(const BorderedSystem &system, const BorderedVector &rhs,
                                             double reduction, BorderedVector &solution) const
{
  const BlockVector block_rhs = to_block(rhs);
  BlockVector block_solution = to_block(rhs);
  block_solution = 0;
  const unsigned int n_iterations = reduce_residual(
    BorderedOperator{ system }, BorderedPreconditioner{ *preconditioner, eliminated_border, inverse_schur },
    block_rhs, reduction, block_solution);
  solution.body = block_solution.block(0);
  solution.motion = motion_of(block_solution);
  return n_iterations;
}

unsigned int BorderedSolver::solve_by_schur_complement(const BorderedSystem &system,
                                                       const BorderedVector &rhs, double reduction,
                                                       BorderedVector &solution, bool is_same)
{
  // x = A^-1 (r - G q) with (C - H' A^-1 G) q = s - H' A^-1 r.
  schur = system.corner;
  unsigned int n_iterations = 0;
  const auto eliminate = [&](const VectorType &column, VectorType &result)
  {
    result.reinit(column);
    n_iterations = std::max(n_iterations, solve_body(system.matrix, column, reduction, result));
  };
  for (unsigned int i = 0; i < 3; ++i)
  {
    if (!is_same)
      eliminate(system.border[i], columns[i]);
    schur.col(i) -= products(*system.condition_border, columns[i]);
  }
  eliminate(rhs.body, solution.body);
  const Eigen::FullPivLU<Eigen::Matrix3d> factors(schur);
  if (!factors.isInvertible())
    throw ContactFailure(ContactOutcome::linear_solver_failed,
                         "the conditions on the contact forces do not determine the table's motions.");
  solution.motion = factors.solve(rhs.motion - products(*system.condition_border, solution.body));
  for (unsigned int i = 0; i < 3; ++i)
    solution.body.add(-solution.motion(i), columns[i]);
  return n_iterations;
}

unsigned int BorderedSolver::solve(const BorderedSystem &system, const BorderedVector &rhs, double reduction,
                                   BorderedVector &solution, bool is_same)
{
  const bool fresh = !preconditioner;
  if (fresh)
    build_preconditioner(system);
  const unsigned int n_iterations = system.condition_border
                                      ? solve_by_schur_complement(system, rhs, reduction, solution, is_same)
                                      : solve_symmetric(system, rhs, reduction, solution);
  if (n_iterations > patience && !fresh)
    preconditioner.reset();
  return n_iterations;
}

} // namespace stemware::fem
