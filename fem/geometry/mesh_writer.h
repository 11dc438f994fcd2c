#pragma once

#include "fem/geometry/glass_profile.h"

#include <iosfwd>

namespace dealii
{
template <int dim, int spacedim>
class Triangulation;
}

namespace stemware::fem
{

/// Moves the contact zone's vertices up by the crown's gap, so that a mesh file says all about its rim:
/// between vertices the crown becomes a polygon. For generated meshes, whose land is flat.
void move_to_crown(const GlassProfile &profile, dealii::Triangulation<3, 3> &triangulation);

/// Writes Gmsh's format 2.2, lengths with 17 digits: linear hexahedra, and quadrilaterals with their boundary
/// ids for the stem cut and the contact zone.
void write_msh(const dealii::Triangulation<3, 3> &triangulation, std::ostream &stream);

/// Writes a mesh for ParaView: cells with straight edges; for each its scaled Jacobian (mesh_quality.h) and
/// the largest of its boundary ids.
void write_mesh_vtu(const dealii::Triangulation<3, 3> &triangulation, std::ostream &stream);

} // namespace stemware::fem
