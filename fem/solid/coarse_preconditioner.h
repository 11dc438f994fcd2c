#pragma once

#include <deal.II/lac/trilinos_precondition.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <memory>
#include <vector>

namespace stemware::fem
{

/// Returns algebraic multigrid by smoothed aggregation (ML of Trilinos) for the stiffness @p matrix of linear
/// elements. vmult() is one W-cycle without smoothing on the finest level, which is left to the caller:
/// symmetric and positive semidefinite. A small matrix is factorised.
///
/// @p modes: displacements of the rigid motions at the rows that this rank owns, 0 at constrained rows, one
/// motion after the other. Keeps references to both arguments.
std::unique_ptr<dealii::TrilinosWrappers::PreconditionAMG>
coarse_preconditioner(const dealii::TrilinosWrappers::SparseMatrix &matrix, std::vector<double> &modes);

} // namespace stemware::fem
