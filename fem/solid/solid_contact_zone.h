#pragma once

#include "fem/contact/contact_surface.h"
#include "fem/solid/contact_nodes.h"

#include <functional>
#include <memory>
#include <vector>

namespace stemware::fem
{

struct SolidLevel;

/// Lines of a contact face: many, because line integrals are not smooth across the contact's border.
constexpr unsigned int default_lines_per_face = 8;

/// Gap between the undeformed contact zone and a plane table at (x, y), in addition to the z of the mesh [m].
using SolidGap = std::function<double(double x, double y)>;

/// Part of the contact zone of a hexahedral mesh on this rank.
struct SolidContactZone
{
  ContactSurface surface;
  double smallest_cell = 0; ///< shortest edge of a contact face of all ranks [m]
};

/// Positions of the horizontal displacements of the own contact nodes among this rank's dofs.
struct HorizontalPlaces
{
  unsigned int node;
  unsigned int x, y;
};

/// Returns the places of the horizontal displacements of the owned contact @p nodes.
std::vector<HorizontalPlaces> horizontal_places(const SolidLevel &mesh, const ContactNodes &nodes);

/// Returns the vertical dofs on this rank's faces of FootBoundary::contact_zone, parents instead of hanging
/// nodes.
std::vector<dealii::types::global_dof_index> contact_dofs(const SolidLevel &mesh);

/// Describes this rank's faces with FootBoundary::contact_zone; @p nodes include contact_dofs(). A face has
/// @p lines_per_face lines at Gauss points of its more azimuthal direction; hanging nodes are replaced by
/// their parents; the gap is z plus @p gap(x, y). Throws std::invalid_argument if no rank has such a face.
SolidContactZone describe_contact_zone(const SolidLevel &mesh, const ContactNodes &nodes, const SolidGap &gap,
                                       unsigned int lines_per_face);

/// Contact nodes of a coarse mesh, and their interpolation to the contact nodes of a finer mesh.
struct ContactInterpolation
{
  std::shared_ptr<const ContactNodes> coarse_nodes; ///< contact_dofs(), and nodes used by the rows
  Eigen::SparseMatrix<double> matrix;               ///< shape [n fine, n coarse]
};

/// Returns the interpolation from contact nodes of @p coarse to @p fine_nodes of @p fine. Cells of the two
/// meshes are equal or parent and child; elements and ranks may differ.
ContactInterpolation interpolation_between(const SolidLevel &coarse, const SolidLevel &fine,
                                           const ContactNodes &fine_nodes);

} // namespace stemware::fem
