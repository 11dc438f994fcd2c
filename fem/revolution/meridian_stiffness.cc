#include "fem/revolution/meridian_stiffness.h"

#include "fem/revolution/harmonic_stiffness.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe.h>
#include <deal.II/fe/fe_values.h>

namespace stemware::fem
{

using namespace dealii;

MeridianStiffness::MeridianStiffness(const Mapping<2> &mapping, const DoFHandler<2> &dof_handler,
                                     const ElasticMaterial &material)
{
  const FiniteElement<2> &element = dof_handler.get_fe();
  const unsigned int n_dofs = element.n_dofs_per_cell(), n_shapes = n_dofs / 3;
  std::vector<unsigned int> order; // element numbering of the cell's degrees of freedom
  for (unsigned int i = 0; i < n_shapes; ++i)
    for (unsigned int c = 0; c < 3; ++c)
      order.push_back(element.component_to_system_index(c, i));
  const HarmonicStiffness stiffness(material);
  FEValues<2> fe_values(mapping, element, QGauss<2>(element.degree + 1),
                        update_values | update_gradients | update_JxW_values | update_quadrature_points);
  std::vector<types::global_dof_index> dofs(n_dofs);
  Eigen::MatrixXd fields(fe_values.n_quadrature_points, HarmonicStiffness::n_fields * n_shapes);
  Eigen::VectorXd weights(fe_values.n_quadrature_points);
  for (const auto &cell : dof_handler.active_cell_iterators())
  {
    fe_values.reinit(cell);
    for (const unsigned int q : fe_values.quadrature_point_indices())
    {
      const double radius = fe_values.quadrature_point(q)[0];
      weights(q) = fe_values.JxW(q) * radius;
      for (unsigned int i = 0; i < n_shapes; ++i)
      {
        const Tensor<1, 2> gradient = fe_values.shape_grad(order[3 * i], q);
        fields(q, i) = gradient[0];
        fields(q, n_shapes + i) = gradient[1];
        fields(q, 2 * n_shapes + i) = fe_values.shape_value(order[3 * i], q) / radius;
      }
    }
    Cell entry;
    cell->get_dof_indices(dofs);
    for (const unsigned int i : order)
      entry.dofs.push_back(dofs[i]);
    const auto parts = stiffness.parts(fields.transpose() * weights.asDiagonal() * fields);
    for (std::size_t k = 0; k < parts.size(); ++k)
      // The parts are symmetric, so their row-major storage equals the column-major storage.
      entry.parts[k] = FullMatrix<double>(n_dofs, n_dofs, parts[k].data());
    cells.push_back(std::move(entry));
  }
}

std::array<double, 3> MeridianStiffness::factors_of(unsigned int harmonic)
{
  const double n = harmonic;
  return { 1, n, n * n };
}

void MeridianStiffness::assemble(const std::array<double, 3> &factors,
                                 const AffineConstraints<double> &constraints,
                                 SparseMatrix<double> &matrix) const
{
  matrix = 0;
  for (const Cell &cell : cells)
  {
    FullMatrix<double> cell_matrix(cell.parts[0].m(), cell.parts[0].n());
    cell_matrix.add(factors[0], cell.parts[0], factors[1], cell.parts[1], factors[2], cell.parts[2]);
    constraints.distribute_local_to_global(cell_matrix, cell.dofs, matrix);
  }
}

} // namespace stemware::fem
