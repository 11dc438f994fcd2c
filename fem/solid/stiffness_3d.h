#pragma once

#include "fem/elasticity/elastic_material.h"

#include <deal.II/base/tensor_function.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/mapping.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <deal.II/lac/trilinos_vector.h>

namespace stemware::fem
{

/// Stiffness of small-strain isotropic elasticity: K_ij = int lambda div(phi_i) div(phi_j) + 2 mu eps(phi_i)
/// : eps(phi_j) dx, with
/// @p constraints eliminated symmetrically. The element is an FESystem of three equal scalar elements, Gauss
/// points degree + 1 a direction.
/// @p matrix comes with its sparsity and is overwritten.
void assemble_stiffness(const dealii::Mapping<3> &mapping, const dealii::DoFHandler<3> &dof_handler,
                        const ElasticMaterial &material, const dealii::AffineConstraints<double> &constraints,
                        dealii::TrilinosWrappers::SparseMatrix &matrix);

/// The stiffness matrix and a right-hand side: int @p body_force . phi_i dx [N], inhomogeneous constraints
/// moved over to it. @p rhs is overwritten.
void assemble_stiffness(const dealii::Mapping<3> &mapping, const dealii::DoFHandler<3> &dof_handler,
                        const ElasticMaterial &material, const dealii::AffineConstraints<double> &constraints,
                        const dealii::TensorFunction<1, 3> &body_force,
                        dealii::TrilinosWrappers::SparseMatrix &matrix,
                        dealii::TrilinosWrappers::MPI::Vector &rhs);

} // namespace stemware::fem
