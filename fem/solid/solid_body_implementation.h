#pragma once

#include "fem/elasticity/stiffness_3d.h"
#include "fem/geometry/boundary_ids.h"
#include "fem/solid/bordered_solver.h"
#include "fem/solid/solid_body.h"
#include "fem/solid/solid_contact_zone.h"

#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/mapping_q.h>

namespace stemware::fem
{

/// deal.II's side of a SolidBody, kept out of its header. Shared by solid_body.cc (mechanics) and
/// solid_output.cc (pictures).
struct SolidBody::Implementation
{
  Implementation(dealii::Triangulation<3> &triangulation, const ElasticMaterial &material,
                 const SolidOptions &options);

  BorderedSolver::MakePreconditioner preconditioner_maker(LinearSolver kind) const;

  /// B' applied to values at the contact nodes.
  dealii::TrilinosWrappers::MPI::Vector scatter(const Eigen::VectorXd &nodal) const;
  /// B applied to a vector of dofs; the same on all ranks.
  Eigen::VectorXd restrict(const dealii::TrilinosWrappers::MPI::Vector &vector) const;
  /// tangent = K + B' T B.
  void set_tangent(const Eigen::SparseMatrix<double> &contact_tangent);
  /// B' forces - K u.
  dealii::TrilinosWrappers::MPI::Vector residual(const Eigen::VectorXd &forces) const;

  const MPI_Comm communicator;
  const dealii::MappingQ<3> mapping;
  const dealii::FESystem<3> element;
  dealii::DoFHandler<3> dof_handler;
  const ElasticMaterial material;
  dealii::IndexSet locally_owned;
  dealii::IndexSet locally_relevant;
  dealii::AffineConstraints<double> constraints; ///< clamped stem cut

  dealii::TrilinosWrappers::SparseMatrix stiffness; ///< K
  dealii::TrilinosWrappers::SparseMatrix tangent;   ///< K + B' T B of the last solve
  dealii::TrilinosWrappers::MPI::Vector displacement;
  dealii::TrilinosWrappers::MPI::Vector increment; ///< of the last solve

  SolidContactZone zone;
  std::unique_ptr<BorderedSolver> solver;

private:
  void clamp_stem_cut();
  void assemble();
};

} // namespace stemware::fem
