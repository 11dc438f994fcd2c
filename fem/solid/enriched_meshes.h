#pragma once

#include <deal.II/grid/tria.h>

#include <memory>
#include <vector>

namespace stemware::fem
{

/// Copies of @p mesh, each with more cells halved once than the one before: all contact faces between the
/// radii @p inner and @p outer [m], and along the edges of the boundary where the body fills more than a
/// half-space. @p mesh is distributed over its communicator. Collective.
std::vector<std::shared_ptr<const dealii::Triangulation<3>>>
enriched_meshes(const dealii::Triangulation<3> &mesh, double inner, double outer);

} // namespace stemware::fem
