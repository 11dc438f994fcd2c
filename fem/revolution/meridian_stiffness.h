#pragma once

#include "fem/geometry/elastic_material.h"

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/mapping.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/vector.h>

#include <array>
#include <vector>

namespace stemware::fem
{

/// Stiffness of a body of revolution for every harmonic at once. Components 0, 1, 2 are u_r cos(n theta),
/// u_theta sin(n theta), u_z cos(n theta). Without the factor pi (1 + delta_n0) of the integral over theta:
/// forces are amplitudes per radian.
class MeridianStiffness
{
public:
  /// Integrates the parts of K_n = K_0 + n K_1 + n^2 K_2 over every cell.
  MeridianStiffness(const dealii::Mapping<2> &mapping, const dealii::DoFHandler<2> &dof_handler,
                    const ElasticMaterial &material);

  /// Returns the factors of K_0, K_1 and K_2 in K_n: 1, n and n^2.
  static std::array<double, 3> factors_of(unsigned int harmonic);

  /// Assembles the sum of K_0, K_1 and K_2 times @p factors into @p matrix, whose sparsity pattern must fit,
  /// with @p constraints eliminated symmetrically.
  void assemble(const std::array<double, 3> &factors, const dealii::AffineConstraints<double> &constraints,
                dealii::SparseMatrix<double> &matrix) const;

private:
  struct Cell
  {
    std::vector<dealii::types::global_dof_index> dofs; ///< 3 i + c: component c of shape function i
    std::array<dealii::FullMatrix<double>, 3> parts;   ///< factors of 1, n and n^2
  };
  std::vector<Cell> cells;
};

} // namespace stemware::fem
