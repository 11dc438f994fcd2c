#pragma once

namespace stemware::fem
{

/// Report on a mesh file that has been read.
struct MeshReport
{
  /// True if the rim vertices lie on circles to 1e-6 of the radius; then a cylindrical manifold is attached.
  bool round_rim = false;
  double rim_radius = 0;               ///< (inner + outer)/2 of the contact zone [m]
  unsigned int n_symmetry_sectors = 1; ///< equal parts round the axis (mesh_quality.h)
  /// Share of the land's area that straight edges cut off, estimated from their angles; 0 for a round rim.
  double land_area_deficit = 0;
};

/// Options of a mesh file: unit of its coordinates, ids of its faces.
struct MeshFileOptions
{
  unsigned int contact_id = 2; ///< id of the faces that may touch the table
  unsigned int stem_id = 1;    ///< id of the faces of the stem cut
  /// Height above the mesh's lowest point [m] below which downward faces are the contact zone, whatever their
  /// ids, and without faces of stem_id the top is the stem cut. 0: ids only.
  double contact_height = 0;
  double unit = 1; ///< unit of the coordinates [m]
};

} // namespace stemware::fem
