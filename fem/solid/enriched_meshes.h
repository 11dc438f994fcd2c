#pragma once

#include <deal.II/grid/tria.h>

#include <memory>
#include <vector>

namespace stemware::fem
{

/// Returns copies of @p mesh, each finer than the one before: halved are the contact faces between the radii
/// @p inner and @p outer [m] and the cells along re-entrant edges of the boundary. @p mesh is distributed
/// over its communicator. Collective.
std::vector<std::shared_ptr<const dealii::Triangulation<3>>>
enriched_meshes(const dealii::Triangulation<3> &mesh, double inner, double outer);

} // namespace stemware::fem
