#pragma once

#include "fem/geometry/elastic_material.h"

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/mapping.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

namespace stemware::fem
{

/// Assembles the stiffness of small-strain isotropic elasticity, K_ij = int lambda div(phi_i) div(phi_j) + 2
/// mu eps(phi_i) : eps(phi_j) dx. The homogeneous @p constraints are eliminated symmetrically. The element is
/// an FESystem of three scalar elements, with degree + 1 Gauss points per direction. @p matrix has this
/// rank's rows.
void assemble_stiffness(const dealii::Mapping<3> &mapping, const dealii::DoFHandler<3> &dof_handler,
                        const ElasticMaterial &material, const dealii::AffineConstraints<double> &constraints,
                        dealii::TrilinosWrappers::SparseMatrix &matrix);

} // namespace stemware::fem
