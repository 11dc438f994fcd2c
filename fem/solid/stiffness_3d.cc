#include "fem/solid/stiffness_3d.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe.h>
#include <deal.II/fe/fe_values.h>

#include <Eigen/Core>

#include <cmath>

namespace stemware::fem
{

using namespace dealii;

namespace
{

/// Computes element matrices; holds what is the same for all cells.
class ElementStiffness
{
public:
  ElementStiffness(const Mapping<3> &mapping, const FiniteElement<3> &element,
                   const ElasticMaterial &material)
      : lambda(material.lame_lambda())
      , shear(material.shear_modulus())
      , quadrature(element.degree + 1)
      , fe_values(mapping, element, quadrature,
                  update_values | update_gradients | update_JxW_values | update_quadrature_points)
      , n_dofs(element.n_dofs_per_cell())
      , dof_of(n_dofs)
  {
    for (unsigned int i = 0; i < n_dofs; ++i)
      dof_of[element.system_to_component_index(i).second * 3 + element.system_to_component_index(i).first] =
        i;
  }

  void reinit(const DoFHandler<3>::active_cell_iterator &cell) { fe_values.reinit(cell); }

  /// [3 a + i, 3 b + j] products int d_i N_a d_j N_b, gathered by one matrix product, give every term of the
  /// stiffness.
  void compute(FullMatrix<double> &matrix)
  {
    const unsigned int n_shapes = n_dofs / 3;
    const unsigned int n_points = quadrature.size();
    Eigen::MatrixXd gradients(n_dofs, n_points);
    for (unsigned int a = 0; a < n_shapes; ++a)
    {
      const unsigned int dof = dof_of[3 * a];
      for (unsigned int q = 0; q < n_points; ++q)
      {
        const Tensor<1, 3> gradient = std::sqrt(fe_values.JxW(q)) * fe_values.shape_grad_component(dof, q, 0);
        for (unsigned int i = 0; i < 3; ++i)
          gradients(3 * a + i, q) = gradient[i];
      }
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
            matrix(dof_of[3 * a + i], dof_of[3 * b + j]) = stiffness(i, j);
      }
  }

  void compute_load(const TensorFunction<1, 3> &body_force, Vector<double> &load)
  {
    load = 0;
    for (unsigned int q = 0; q < quadrature.size(); ++q)
    {
      const Tensor<1, 3> force = body_force.value(fe_values.quadrature_point(q));
      for (unsigned int i = 0; i < n_dofs; ++i)
        load(i) += force[fe_values.get_fe().system_to_component_index(i).first] *
                   fe_values.shape_value(i, q) * fe_values.JxW(q);
    }
  }

private:
  const double lambda;
  const double shear;
  const QGauss<3> quadrature;
  FEValues<3> fe_values;
  const unsigned int n_dofs;
  std::vector<unsigned int> dof_of; ///< 3 * scalar shape + component -> local dof
};

void assemble(const Mapping<3> &mapping, const DoFHandler<3> &dof_handler, const ElasticMaterial &material,
              const AffineConstraints<double> &constraints, const TensorFunction<1, 3> *body_force,
              TrilinosWrappers::SparseMatrix &matrix, TrilinosWrappers::MPI::Vector *rhs)
{
  const FiniteElement<3> &element = dof_handler.get_fe();
  ElementStiffness stiffness(mapping, element, material);
  FullMatrix<double> cell_matrix(element.n_dofs_per_cell(), element.n_dofs_per_cell());
  Vector<double> cell_load(element.n_dofs_per_cell());
  std::vector<types::global_dof_index> dofs(element.n_dofs_per_cell());
  matrix = 0;
  if (rhs)
    *rhs = 0;
  for (const auto &cell : dof_handler.active_cell_iterators())
  {
    if (!cell->is_locally_owned())
      continue;
    stiffness.reinit(cell);
    stiffness.compute(cell_matrix);
    cell->get_dof_indices(dofs);
    if (!rhs)
    {
      constraints.distribute_local_to_global(cell_matrix, dofs, matrix);
      continue;
    }
    stiffness.compute_load(*body_force, cell_load);
    constraints.distribute_local_to_global(cell_matrix, cell_load, dofs, matrix, *rhs);
  }
  matrix.compress(VectorOperation::add);
  if (rhs)
    rhs->compress(VectorOperation::add);
}

} // namespace

void assemble_stiffness(const Mapping<3> &mapping, const DoFHandler<3> &dof_handler,
                        const ElasticMaterial &material, const AffineConstraints<double> &constraints,
                        TrilinosWrappers::SparseMatrix &matrix)
{
  assemble(mapping, dof_handler, material, constraints, nullptr, matrix, nullptr);
}

void assemble_stiffness(const Mapping<3> &mapping, const DoFHandler<3> &dof_handler,
                        const ElasticMaterial &material, const AffineConstraints<double> &constraints,
                        const TensorFunction<1, 3> &body_force, TrilinosWrappers::SparseMatrix &matrix,
                        TrilinosWrappers::MPI::Vector &rhs)
{
  assemble(mapping, dof_handler, material, constraints, &body_force, matrix, &rhs);
}

} // namespace stemware::fem
