#pragma once

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <memory>

namespace stemware::fem
{

/// Returns a mapping of @p mesh of degree @p degree without gaps at hanging nodes: finer faces lie on the
/// polynomials of the coarser face, not on the exact surface. deal.II's mapping leaves gaps of a few 1e-8 m,
/// across which displacements are discontinuous in space: on meshes refined at some azimuths only, a_2 was
/// wrong by 2e-5 of a_0. @p mesh must outlive the mapping. Collective. Throws std::runtime_error for inverted
/// cells (refined next to a coarse chord of the rim).
std::unique_ptr<const dealii::MappingQ<3>> conforming_mapping(const dealii::Triangulation<3> &mesh,
                                                              unsigned int degree);

/// Mesh with finite elements on it.
struct SolidLevel
{
  /// Clamps FootBoundary::stem_cut. Throws std::invalid_argument without a stem cut.
  SolidLevel(std::shared_ptr<const dealii::Triangulation<3>> triangulation, unsigned int degree,
             unsigned int mapping_degree);

  using Vector = dealii::LinearAlgebra::distributed::Vector<double>;

  /// Returns a zero vector of the unknowns with the ghost values of this rank's cells. Collective.
  Vector ghosted() const;
  /// Returns @p vector with ghost values, and with the values of constrained unknowns. Collective.
  Vector distributed(const Vector &vector) const;

  const std::shared_ptr<const dealii::Triangulation<3>> triangulation;
  const std::unique_ptr<const dealii::MappingQ<3>> geometry; ///< conforming_mapping()
  const dealii::MappingQ<3> &mapping;
  const dealii::FESystem<3> element;
  dealii::DoFHandler<3> dof_handler;
  dealii::AffineConstraints<double> constraints; ///< clamped stem cut, hanging nodes
};

} // namespace stemware::fem
