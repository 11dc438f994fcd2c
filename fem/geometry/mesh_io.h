#pragma once

#include "fem/geometry/glass_profile.h"

#include <iosfwd>
#include <string>

namespace dealii
{
template <int dim, int spacedim>
class Triangulation;
}

namespace stemware::fem
{

/// Report on a mesh file that has been read.
struct MeshReport
{
  unsigned int n_cells = 0;
  unsigned int n_contact_faces = 0;
  /// True if the rim vertices lie on circles to 1e-6 of the radius: the cylindrical manifold is attached.
  bool round_rim = false;
  double rim_radius = 0;               ///< (inner + outer)/2 of the contact zone [m]
  unsigned int n_symmetry_sectors = 1; ///< equal parts round the axis (mesh_quality.h)
  /// Share of the land's area that straight edges cut off, estimated from their angles; 0 for a round rim.
  double land_area_deficit = 0;
};

/// Options of a mesh file: unit of its coordinates, ids of its faces.
struct MeshFileOptions
{
  unsigned int contact_id = 2; ///< of the faces that may touch the table
  unsigned int stem_id = 1;    ///< of the faces where the stem was cut
  /// Height above the mesh's lowest point [m] below which downward faces are the contact zone, whatever their
  /// ids; without faces of stem_id the top is the stem cut. 0: ids only.
  double contact_height = 0;
  double unit = 1; ///< of the coordinates [m]
};

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
