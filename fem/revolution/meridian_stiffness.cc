#include "fem/revolution/meridian_stiffness.h"

#include "fem/geometry/elastic_material.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe.h>
#include <deal.II/fe/fe_values.h>

#include <Eigen/Core>

#include <array>

namespace stemware::fem
{

using namespace dealii;

namespace
{

constexpr Eigen::Index n_fields = 3;

/// [part][c][d](p, q): stiffness between the components c and d for the product of the fields p and q.
using Coefficients = std::array<std::array<std::array<Eigen::Matrix3d, 3>, 3>, 3>;

/// Strains rr, zz, theta theta, rz, r theta, z theta (engineering shear strains) of each field.
using StrainOfFields = Eigen::Matrix<double, 6, n_fields>;

/// Strain of harmonic n of a displacement component: constant + n linear.
struct ComponentStrain
{
  StrainOfFields constant = StrainOfFields::Zero();
  StrainOfFields linear = StrainOfFields::Zero();
};

std::array<ComponentStrain, 3> strains_of_components()
{
  enum
  {
    rr,
    zz,
    tt,
    rz,
    rt,
    zt
  };
  enum
  {
    along_r,
    along_z,
    over_r
  };
  std::array<ComponentStrain, 3> strains;
  auto &[radial, azimuthal, vertical] = strains;
  radial.constant(rr, along_r) = radial.constant(tt, over_r) = radial.constant(rz, along_z) = 1;
  radial.linear(rt, over_r) = -1;
  azimuthal.constant(rt, along_r) = azimuthal.constant(zt, along_z) = 1;
  azimuthal.constant(rt, over_r) = -1;
  azimuthal.linear(tt, over_r) = 1;
  vertical.constant(zz, along_z) = vertical.constant(rz, along_r) = 1;
  vertical.linear(zt, over_r) = -1;
  return strains;
}

/// Returns the element stiffness of the displacement harmonics u_r cos(n theta), u_theta sin(n theta), u_z
/// cos(n theta) (docs/method/revolution.md, "Harmonics"). All strains combine the fields dN/dr, dN/dz and N/r
/// of a shape function N, so the integrals of products of these fields give the stiffness of every harmonic.
Coefficients coefficients_of(const ElasticMaterial &material)
{
  Coefficients coefficients;
  Eigen::Matrix<double, 6, 6> moduli = Eigen::Matrix<double, 6, 6>::Zero();
  moduli.topLeftCorner<3, 3>().setConstant(material.lame_lambda());
  moduli.diagonal().head<3>().array() += 2 * material.shear_modulus();
  moduli.diagonal().tail<3>().setConstant(material.shear_modulus());
  const auto strains = strains_of_components();
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t d = 0; d < 3; ++d)
    {
      const ComponentStrain &a = strains[c], &b = strains[d];
      coefficients[0][c][d] = a.constant.transpose() * moduli * b.constant;
      coefficients[1][c][d] =
        a.constant.transpose() * moduli * b.linear + a.linear.transpose() * moduli * b.constant;
      coefficients[2][c][d] = a.linear.transpose() * moduli * b.linear;
    }
  return coefficients;
}

/// Returns K_0, K_1 and K_2 of K_n = K_0 + n K_1 + n^2 K_2 for m shape functions. Row 3 i + c belongs to the
/// component c (r, theta, z) of function i. @p products [3 m, 3 m]: entry (p m + i, q m + j) is the integral
/// of field p (dN/dr, dN/dz or N/r) of function i times field q of function j.
std::array<Eigen::MatrixXd, 3> parts_of(const Coefficients &coefficients, const Eigen::MatrixXd &products)
{
  const Eigen::Index m = products.rows() / n_fields;
  std::array<Eigen::MatrixXd, 3> parts;
  Eigen::MatrixXd block(m, m);
  for (std::size_t k = 0; k < parts.size(); ++k)
  {
    parts[k].resize(3 * m, 3 * m);
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t d = 0; d < 3; ++d)
      {
        block.setZero();
        const Eigen::Matrix3d &factors = coefficients[k][c][d];
        for (Eigen::Index p = 0; p < n_fields; ++p)
          for (Eigen::Index q = 0; q < n_fields; ++q)
            if (factors(p, q) != 0)
              block += factors(p, q) * products.block(p * m, q * m, m, m);
        for (Eigen::Index j = 0; j < m; ++j)
          for (Eigen::Index i = 0; i < m; ++i)
            parts[k](3 * i + static_cast<Eigen::Index>(c), 3 * j + static_cast<Eigen::Index>(d)) =
              block(i, j);
      }
  }
  return parts;
}

} // namespace

MeridianStiffness::MeridianStiffness(const Mapping<2> &mapping, const DoFHandler<2> &dof_handler,
                                     const ElasticMaterial &material)
{
  const FiniteElement<2> &element = dof_handler.get_fe();
  const unsigned int n_dofs = element.n_dofs_per_cell(), n_shapes = n_dofs / 3;
  std::vector<unsigned int> order; // [3 i + c]: deal.II's index of component c of function i
  for (unsigned int i = 0; i < n_shapes; ++i)
    for (unsigned int c = 0; c < 3; ++c)
      order.push_back(element.component_to_system_index(c, i));
  const Coefficients coefficients = coefficients_of(material);
  FEValues<2> fe_values(mapping, element, QGauss<2>(element.degree + 1),
                        update_values | update_gradients | update_JxW_values | update_quadrature_points);
  std::vector<types::global_dof_index> dofs(n_dofs);
  Eigen::MatrixXd fields(fe_values.n_quadrature_points, n_fields * n_shapes);
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
    const auto parts = parts_of(coefficients, fields.transpose() * weights.asDiagonal() * fields);
    for (std::size_t k = 0; k < parts.size(); ++k)
      // The parts are symmetric, so row-major and column-major storage are equal.
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
