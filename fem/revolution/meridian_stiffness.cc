#include "fem/revolution/meridian_stiffness.h"

#include "fem/elasticity/harmonic_strain.h"

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
  const unsigned int n_dofs = element.n_dofs_per_cell();
  const double lambda = material.lame_lambda();
  const double shear = material.shear_modulus();
  FEValues<2> fe_values(mapping, element, QGauss<2>(element.degree + 1),
                        update_values | update_gradients | update_JxW_values | update_quadrature_points);
  std::vector<ShapeStrain> strains(n_dofs);
  for (const auto &cell : dof_handler.active_cell_iterators())
  {
    fe_values.reinit(cell);
    Cell stiffness;
    stiffness.dofs.resize(n_dofs);
    cell->get_dof_indices(stiffness.dofs);
    stiffness.parts.fill(FullMatrix<double>(n_dofs, n_dofs));
    for (const unsigned int q : fe_values.quadrature_point_indices())
    {
      const double radius = fe_values.quadrature_point(q)[0];
      const double weight = fe_values.JxW(q) * radius;
      for (unsigned int i = 0; i < n_dofs; ++i)
      {
        const Tensor<1, 2> gradient = fe_values.shape_grad(i, q);
        strains[i] = strain_of(element.system_to_component_index(i).first, fe_values.shape_value(i, q),
                               { gradient[0], gradient[1] }, radius);
      }
      for (unsigned int i = 0; i < n_dofs; ++i)
        for (unsigned int j = 0; j <= i; ++j)
        {
          const ShapeStrain &a = strains[i];
          const ShapeStrain &b = strains[j];
          stiffness.parts[0](i, j) += weight * energy_product(a.constant, b.constant, lambda, shear);
          stiffness.parts[1](i, j) += weight * (energy_product(a.constant, b.linear, lambda, shear) +
                                                energy_product(a.linear, b.constant, lambda, shear));
          stiffness.parts[2](i, j) += weight * energy_product(a.linear, b.linear, lambda, shear);
        }
    }
    for (FullMatrix<double> &part : stiffness.parts) // symmetric
      for (unsigned int i = 0; i < n_dofs; ++i)
        for (unsigned int j = 0; j < i; ++j)
          part(j, i) = part(i, j);
    cells.push_back(std::move(stiffness));
  }
}

double MeridianStiffness::product(unsigned int harmonic, unsigned int active_cell,
                                  const Vector<double> &first, const Vector<double> &second) const
{
  const std::array<FullMatrix<double>, 3> &parts = cells[active_cell].parts;
  const std::array<double, 3> factors = factors_of(harmonic);
  double sum = 0;
  for (std::size_t k = 0; k < parts.size(); ++k)
    sum += factors[k] * parts[k].matrix_scalar_product(first, second);
  return sum;
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
