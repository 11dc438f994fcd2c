#pragma once

#include "fem/geometry/glass_profile.h"
#include "fem/geometry/mesh_report.h"
#include "fem/geometry/triangulation.h"

#include <iosfwd>
#include <string>

namespace stemware::fem
{

/// Reads a file as read_hexahedra(), axis along z; faces without an id are free. Throws std::invalid_argument
/// if that fails, without a stem cut or contact zone (the message lists the file's ids and names the entry to
/// set), and for second-order elements on a rim that is not round.
MeshReport read_foot_mesh(const std::string &file_name, dealii::Triangulation<3, 3> &triangulation,
                          const MeshFileOptions &marks = {});

/// Moves the contact zone's vertices of a generated mesh up by the crown's gap, for write_msh().
void move_to_crown(const GlassProfile &profile, dealii::Triangulation<3, 3> &triangulation);

/// Writes Gmsh's format 2.2 with 17 digits: hexahedra, and stem and contact faces with boundary ids.
void write_msh(const dealii::Triangulation<3, 3> &triangulation, std::ostream &stream);

/// Writes a mesh for ParaView: cells with straight edges, their scaled_jacobians() and largest boundary ids.
void write_mesh_vtu(const dealii::Triangulation<3, 3> &triangulation, std::ostream &stream);

} // namespace stemware::fem
