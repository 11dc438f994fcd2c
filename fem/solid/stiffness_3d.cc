#include "fem/solid/stiffness_3d.h"

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/trilinos_sparsity_pattern.h>

#include <Eigen/Core>

#include <cmath>

namespace stemware::fem
{

using namespace dealii;

namespace
{

/// Computes the stiffness of a cell from the integrals of d_i N_a d_j N_b (shape functions N_a), which one
/// matrix product gives as entries [3 a + i, 3 b + j].
void compute_cell_stiffness(const FEValues<3> &values, const ElasticMaterial &material,
                            FullMatrix<double> &matrix)
{
  const FiniteElement<3> &element = values.get_fe();
  const double lambda = material.lame_lambda(), shear = material.shear_modulus();
  const unsigned int n_shapes = element.n_dofs_per_cell() / 3;
  Eigen::MatrixXd gradients(3 * n_shapes, values.n_quadrature_points);
  for (unsigned int a = 0; a < n_shapes; ++a)
    for (const unsigned int q : values.quadrature_point_indices())
    {
      const Tensor<1, 3> gradient =
        std::sqrt(values.JxW(q)) * values.shape_grad_component(element.component_to_system_index(0, a), q, 0);
      for (unsigned int i = 0; i < 3; ++i)
        gradients(3 * a + i, q) = gradient[i];
    }
  const Eigen::MatrixXd products = gradients * gradients.transpose();
  for (unsigned int a = 0; a < n_shapes; ++a)
    for (unsigned int b = 0; b < n_shapes; ++b)
    {
      const Eigen::Matrix3d block = products.block<3, 3>(3 * a, 3 * b);
      const Eigen::Matrix3d stiffness =
        lambda * block + shear * block.transpose() + shear * block.trace() * Eigen::Matrix3d::Identity();
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          matrix(element.component_to_system_index(i, a), element.component_to_system_index(j, b)) =
            stiffness(i, j);
    }
}

} // namespace

void assemble_stiffness(const Mapping<3> &mapping, const DoFHandler<3> &dof_handler,
                        const ElasticMaterial &material, const AffineConstraints<double> &constraints,
                        TrilinosWrappers::SparseMatrix &matrix)
{
  const MPI_Comm communicator = dof_handler.get_communicator();
  const IndexSet &owned = dof_handler.locally_owned_dofs();
  TrilinosWrappers::SparsityPattern sparsity(
    owned, owned, DoFTools::extract_locally_relevant_dofs(dof_handler), communicator);
  DoFTools::make_sparsity_pattern(dof_handler, sparsity, constraints, false,
                                  Utilities::MPI::this_mpi_process(communicator));
  sparsity.compress();
  matrix.reinit(sparsity);

  const FiniteElement<3> &element = dof_handler.get_fe();
  FEValues<3> values(mapping, element, QGauss<3>(element.degree + 1), update_gradients | update_JxW_values);
  FullMatrix<double> cell_matrix(element.n_dofs_per_cell(), element.n_dofs_per_cell());
  std::vector<types::global_dof_index> dofs(element.n_dofs_per_cell());
  for (const auto &cell : dof_handler.active_cell_iterators())
  {
    if (!cell->is_locally_owned())
      continue;
    values.reinit(cell);
    compute_cell_stiffness(values, material, cell_matrix);
    cell->get_dof_indices(dofs);
    constraints.distribute_local_to_global(cell_matrix, dofs, matrix);
  }
  matrix.compress(VectorOperation::add);
}

} // namespace stemware::fem
