#include "fem/revolution/meridian_stiffness.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe.h>
#include <deal.II/fe/fe_values.h>

namespace stemware::fem
{

using namespace dealii;

namespace
{

/// Strains in the order rr, zz, theta theta, rz, r theta, z theta (shears are engineering strains).
using Strain = std::array<double, 6>;

/// Strain of a shape function: `constant` + n `linear`.
struct ShapeStrain
{
  Strain constant{};
  Strain linear{};
};

/// Of value N and gradient (N_r, N_z) at radius r, in the displacement component given.
ShapeStrain strain_of(unsigned int component, double value, const Tensor<1, 2> &gradient, double radius)
{
  ShapeStrain strain;
  const double hoop = value / radius;
  switch (component)
  {
  case 0:
    strain.constant = { gradient[0], 0, hoop, gradient[1], 0, 0 };
    strain.linear = { 0, 0, 0, 0, -hoop, 0 };
    break;
  case 1:
    strain.constant = { 0, 0, 0, 0, gradient[0] - hoop, gradient[1] };
    strain.linear = { 0, 0, hoop, 0, 0, 0 };
    break;
  default:
    strain.constant = { 0, gradient[1], 0, gradient[0], 0, 0 };
    strain.linear = { 0, 0, 0, 0, 0, -hoop };
  }
  return strain;
}

/// 2 x the energy density's bilinear form.
double energy(const Strain &a, const Strain &b, double lambda, double shear)
{
  double normal = 0;
  double tangential = 0;
  for (unsigned int i = 0; i < 3; ++i)
  {
    normal += a[i] * b[i];
    tangential += a[i + 3] * b[i + 3];
  }
  return lambda * (a[0] + a[1] + a[2]) * (b[0] + b[1] + b[2]) + shear * (2 * normal + tangential);
}

} // namespace

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
        strains[i] = strain_of(element.system_to_component_index(i).first, fe_values.shape_value(i, q),
                               fe_values.shape_grad(i, q), radius);
      for (unsigned int i = 0; i < n_dofs; ++i)
        for (unsigned int j = 0; j < n_dofs; ++j)
        {
          const ShapeStrain &a = strains[i];
          const ShapeStrain &b = strains[j];
          stiffness.parts[0](i, j) += weight * energy(a.constant, b.constant, lambda, shear);
          stiffness.parts[1](i, j) += weight * (energy(a.constant, b.linear, lambda, shear) +
                                                energy(a.linear, b.constant, lambda, shear));
          stiffness.parts[2](i, j) += weight * energy(a.linear, b.linear, lambda, shear);
        }
    }
    cells.push_back(std::move(stiffness));
  }
}

double MeridianStiffness::product(unsigned int harmonic, unsigned int active_cell,
                                  const Vector<double> &first, const Vector<double> &second) const
{
  const std::array<FullMatrix<double>, 3> &parts = cells[active_cell].parts;
  const double n = harmonic;
  return parts[0].matrix_scalar_product(first, second) + n * parts[1].matrix_scalar_product(first, second) +
         n * n * parts[2].matrix_scalar_product(first, second);
}

void MeridianStiffness::assemble(unsigned int harmonic, const AffineConstraints<double> &constraints,
                                 SparseMatrix<double> &matrix) const
{
  matrix = 0;
  const double n = harmonic;
  for (const Cell &cell : cells)
  {
    FullMatrix<double> cell_matrix = cell.parts[0];
    cell_matrix.add(n, cell.parts[1], n * n, cell.parts[2]);
    constraints.distribute_local_to_global(cell_matrix, cell.dofs, matrix);
  }
}

} // namespace stemware::fem
