#pragma once

#include "fem/solid/bordered_solver.h"
#include "fem/solid/friction_corrections.h"
#include "fem/solid/solid_system.h"

#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/mapping_q.h>

namespace stemware::fem
{

/// The equations as a sparse matrix, factorised: for any mesh that is not too large.
class AssembledSystem : public SolidSystem
{
public:
  AssembledSystem(const dealii::Triangulation<3> &triangulation, const ElasticMaterial &material,
                  const SolidBody::Gap &gap, const SolidOptions &options);

  const dealii::DoFHandler<3> &dofs() const override { return dof_handler; }
  const dealii::Mapping<3> &mapping() const override { return geometry; }
  Eigen::VectorXd contact_displacement() const override;
  NewtonIncrement solve(const Eigen::SparseMatrix<double> &tangent, const Eigen::VectorXd &forces,
                        const LinearConditions &conditions, const Eigen::Vector3d &motion) override;
  void update(double step_length) override;
  void reset() override;
  double equilibrium_residual(const Eigen::VectorXd &forces) const override;
  void write_state(std::ostream &stream) const override;
  void read_state(std::istream &stream) override;
  dealii::LinearAlgebra::distributed::Vector<double> displacement_for_output() const override;

private:
  using Vector = dealii::TrilinosWrappers::MPI::Vector;

  void assemble();
  /// B' @p forces with the friction that they bring along.
  Vector contact_load(const Eigen::VectorXd &forces) const;
  /// B' applied to what the ranks' parts have at the contact nodes.
  Vector scatter(const Eigen::VectorXd &parts) const;
  /// B applied to a vector of dofs.
  Eigen::VectorXd restrict(const Vector &vector) const;
  /// tangent = K + B' T B.
  void set_tangent(const Eigen::SparseMatrix<double> &contact_tangent);
  /// The contact's load minus K u.
  Vector residual(const Eigen::VectorXd &forces) const;

  const MPI_Comm communicator;
  const std::unique_ptr<const dealii::MappingQ<3>> conforming;
  const dealii::MappingQ<3> &geometry;
  const dealii::FESystem<3> element;
  dealii::DoFHandler<3> dof_handler;
  dealii::IndexSet locally_owned;
  dealii::AffineConstraints<double> constraints; ///< clamped stem cut

  dealii::TrilinosWrappers::SparseMatrix stiffness; ///< K
  dealii::TrilinosWrappers::SparseMatrix tangent;   ///< K + B' T B of the last solve
  Vector displacement;
  Vector increment; ///< of the last solve
  BorderedSolver solver;
  std::vector<HorizontalPlaces> horizontal;
};

} // namespace stemware::fem
