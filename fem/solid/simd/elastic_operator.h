#pragma once

#include "fem/geometry/elastic_material.h"

#include <deal.II/lac/la_parallel_vector.h>

#include <memory>

namespace dealii
{
template <int dim, int spacedim>
class DoFHandler;
template <int dim, int spacedim>
class Mapping;
template <typename number>
class AffineConstraints;
}

namespace stemware::fem
{

/// Matrix-free stiffness K of assemble_stiffness(), cells in SIMD lanes. @p Number: double or float.
template <typename Number>
class ElasticOperator
{
public:
  using Vector = dealii::LinearAlgebra::distributed::Vector<Number>;

  virtual ~ElasticOperator() = default;

  /// Computes @p dst = K @p src, with the identity in the rows and columns of constrained unknowns.
  virtual void vmult(Vector &dst, const Vector &src) const = 0;

  /// Computes the diagonal of K [N/m], 1 for constrained unknowns.
  virtual void compute_diagonal(Vector &diagonal) const = 0;

  /// Initialises @p vector with the partition of vmult(), ghosts included, and zeros.
  virtual void initialize_dof_vector(Vector &vector) const = 0;
};

/// Makes the operator for an FESystem of three FE_Q of degree 1, 2 or 3; else throws std::invalid_argument.
/// All arguments but the material must outlive the operator.
template <typename Number>
[[gnu::visibility("default")]] std::unique_ptr<ElasticOperator<Number>>
make_elastic_operator(const dealii::Mapping<3, 3> &mapping, const dealii::DoFHandler<3, 3> &dof_handler,
                      const dealii::AffineConstraints<double> &constraints, const ElasticMaterial &material);

/// Returns the number of double-precision SIMD lanes of this build.
[[gnu::visibility("default")]] unsigned int n_simd_lanes();

} // namespace stemware::fem
