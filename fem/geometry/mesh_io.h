#pragma once

#include "fem/geometry/glass_profile.h"
#include "fem/geometry/mesh_report.h"
#include "fem/geometry/triangulation.h"

#include <iosfwd>
#include <string>

namespace stemware::fem
{

/// Reads a file as read_hexahedra(), axis along z; faces without an id are free. Throws std::invalid_argument
/// if that fails, if there is no stem cut or contact zone (the message names the file's names and ids and the
/// entry to set), and for second-order elements on a rim that is not round.
MeshReport read_foot_mesh(const std::string &file_name, dealii::Triangulation<3, 3> &triangulation,
                          const MeshFileOptions &marks = {});

/// Moves the vertices of the contact zone up by the crown's gap, for meshes to be written to a file: between
/// vertices the crown becomes a polygon. For generated meshes, whose land is flat.
void move_to_crown(const GlassProfile &profile, dealii::Triangulation<3, 3> &triangulation);

/// Writes Gmsh's format 2.2, lengths with 17 digits: linear hexahedra, and quadrilaterals with their boundary
/// ids for the stem cut and the contact zone.
void write_msh(const dealii::Triangulation<3, 3> &triangulation, std::ostream &stream);

/// Writes a mesh for ParaView: cells with straight edges; for each its scaled Jacobian (mesh_quality.h) and
/// the largest of its boundary ids.
void write_mesh_vtu(const dealii::Triangulation<3, 3> &triangulation, std::ostream &stream);

} // namespace stemware::fem
