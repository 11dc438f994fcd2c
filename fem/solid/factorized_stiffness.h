#pragma once

#include "fem/elasticity/elastic_material.h"
#include "fem/solid/body_stiffness.h"

#include <deal.II/lac/trilinos_sparse_matrix.h>

namespace stemware::fem
{

/// Stiffness as a sparse matrix, preconditioned by MUMPS factors of a recent K + B' T B; for any mesh of
/// moderate size.
class FactorizedStiffness : public BodyStiffness
{
public:
  /// @p triangulation has to outlive it. Throws as clamp_stem_cut() and conforming_mapping().
  FactorizedStiffness(const dealii::Triangulation<3> &triangulation, unsigned int degree,
                      unsigned int mapping_degree, const ElasticMaterial &material);
  ~FactorizedStiffness() override;

  const SolidLevel &mesh() const override { return level; }
  std::shared_ptr<const ContactNodes> contact_nodes() const override { return nodes; }
  void initialize(Vector &vector) const override;
  void vmult(Vector &dst, const Vector &src) const override { stiffness.vmult(dst, src); }
  /// Factorises if there are no factors. Throws ContactFailure if the factorisation fails.
  void set_contact(const Eigen::SparseMatrix<double> &tangent) override;
  void precondition(Vector &dst, const Vector &src) const override;
  /// Discards the factors if the iterations cost more than a new factorisation.
  void report_iterations(unsigned int n_iterations) override;

private:
  class Factors;

  const SolidLevel level;
  const std::shared_ptr<const ContactNodes> nodes;
  dealii::TrilinosWrappers::SparseMatrix stiffness; ///< K
  std::unique_ptr<const Factors> factors;
  bool are_fresh = false; ///< true if the factors belong to the present T
};

} // namespace stemware::fem
