#pragma once

#include "fem/contact/contact_solution.h"

#include <deal.II/lac/solver_cg.h>

#include <sstream>
#include <stdexcept>

namespace stemware::fem
{

/// Conjugate gradients from @p solution to a residual of @p target, in the units of @p rhs; returns the
/// number of iterations. Collective over the ranks of the vectors. Throws ContactFailure when @p
/// most_iterations do not do.
template <typename Vector, typename Operator, typename Preconditioner>
unsigned int conjugate_gradients(const Operator &matrix, const Preconditioner &preconditioner,
                                 const Vector &rhs, double target, unsigned int most_iterations,
                                 Vector &solution)
{
  dealii::SolverControl control(most_iterations, target, false, false);
  dealii::SolverCG<Vector> solver(control);
  try
  {
    solver.solve(matrix, solution, rhs, preconditioner);
  }
  catch (const dealii::SolverControl::NoConvergence &failure)
  {
    std::ostringstream message;
    message << "conjugate gradients left a residual of " << failure.last_residual << " after "
            << failure.last_step << " iterations (wanted " << target << ", of " << rhs.l2_norm()
            << "); use a mesh with less distorted cells.";
    throw ContactFailure(ContactOutcome::linear_solver_failed, message.str());
  }
  return control.last_step();
}

} // namespace stemware::fem
