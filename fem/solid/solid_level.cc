#include "fem/solid/solid_level.h"

#include "fem/contact/contact_solution.h"
#include "fem/geometry/boundary_ids.h"

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q_cache.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/numerics/vector_tools_interpolate.h>

#include <algorithm>
#include <stdexcept>
#include <string>

namespace stemware::fem
{

using namespace dealii;

namespace
{

/// Throws std::runtime_error if a cell is inverted. This happens if a halved cell is thinner than the
/// distance between the chord and the curved surface of its coarse face.
void require_right_side_out(const Mapping<3> &mapping, const DoFHandler<3> &dof_handler)
{
  const FiniteElement<3> &element = dof_handler.get_fe();
  // deal.II asserts positive JxW values, but no positive determinants.
  FEValues<3> values(mapping, element, QGauss<3>(element.degree + 1), update_jacobians);
  unsigned int n_inverted = 0;
  for (const auto &cell : dof_handler.active_cell_iterators())
    if (cell->is_locally_owned())
    {
      values.reinit(cell);
      const auto points = values.quadrature_point_indices();
      n_inverted += std::any_of(points.begin(), points.end(),
                                [&](unsigned int q) { return values.jacobian(q).determinant() <= 0; });
    }
  n_inverted = Utilities::MPI::sum(n_inverted, dof_handler.get_communicator());
  if (n_inverted > 0)
    throw ContactFailure(ContactOutcome::inverted_cells,
                         "Halving some cells turns " + std::to_string(n_inverted) +
                           " others inside out: the mesh follows the round rim too coarsely; give it more "
                           "azimuthal cells.");
}

AffineConstraints<double> clamp_stem_cut(const DoFHandler<3> &dof_handler)
{
  constexpr auto stem_cut_id = static_cast<types::boundary_id>(FootBoundary::stem_cut);
  const IndexSet clamped =
    DoFTools::extract_boundary_dofs(dof_handler, ComponentMask(3, true), { stem_cut_id });
  if (Utilities::MPI::sum(clamped.n_elements(), dof_handler.get_communicator()) == 0)
    throw std::invalid_argument(
      "The mesh has no stem cut: no boundary face carries the id 1; mark the faces where the stem was cut.");
  const IndexSet relevant = DoFTools::extract_locally_relevant_dofs(dof_handler);
  AffineConstraints<double> constraints(relevant);
  DoFTools::make_hanging_node_constraints(dof_handler, constraints);
  DoFTools::make_zero_boundary_constraints(dof_handler, stem_cut_id, constraints);
  constraints.close();
  return constraints;
}

} // namespace

std::unique_ptr<const MappingQ<3>> conforming_mapping(const Triangulation<3> &mesh, unsigned int degree)
{
  auto smooth = std::make_unique<MappingQ<3>>(degree);
  const MPI_Comm &communicator = mesh.get_communicator();
  if (Utilities::MPI::max(mesh.has_hanging_nodes() ? 1 : 0, communicator) == 0)
    return smooth;
  const FESystem<3> element(FE_Q<3>(degree), 3);
  DoFHandler<3> dof_handler(mesh);
  dof_handler.distribute_dofs(element);
  const IndexSet relevant = DoFTools::extract_locally_relevant_dofs(dof_handler);
  LinearAlgebra::distributed::Vector<double> positions(dof_handler.locally_owned_dofs(), relevant,
                                                       communicator);
  VectorTools::get_position_vector(*smooth, dof_handler, positions);
  AffineConstraints<double> hanging(relevant);
  DoFTools::make_hanging_node_constraints(dof_handler, hanging);
  hanging.close();
  hanging.distribute(positions);
  positions.update_ghost_values();
  // A mapping of degree 1 may read vertices from the mesh instead of the cache, so the degree is at least 2.
  auto conforming = std::make_unique<MappingQCache<3>>(std::max(degree, 2u));
  conforming->initialize(*smooth, dof_handler, positions, false);
  require_right_side_out(*conforming, dof_handler);
  return conforming;
}

SolidLevel::SolidLevel(std::shared_ptr<const Triangulation<3>> mesh, unsigned int degree,
                       unsigned int mapping_degree)
    : triangulation(std::move(mesh))
    , geometry(conforming_mapping(*triangulation, mapping_degree))
    , mapping(*geometry)
    , element(FE_Q<3>(degree), 3)
    , dof_handler(*triangulation)
{
  dof_handler.distribute_dofs(element);
  constraints = clamp_stem_cut(dof_handler);
}

SolidLevel::Vector SolidLevel::ghosted() const
{
  const IndexSet relevant = DoFTools::extract_locally_relevant_dofs(dof_handler);
  return Vector(dof_handler.locally_owned_dofs(), relevant, dof_handler.get_communicator());
}

SolidLevel::Vector SolidLevel::distributed(const Vector &vector) const
{
  Vector result = ghosted();
  result.copy_locally_owned_data_from(vector);
  constraints.distribute(result);
  result.update_ghost_values();
  return result;
}

} // namespace stemware::fem
