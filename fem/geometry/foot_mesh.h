#pragma once

#include "fem/geometry/glass_profile.h"

#include <string>

namespace dealii
{
template <int dim, int spacedim>
class Triangulation;
}

namespace stemware::fem
{

/// Boundary ids of every foot mesh, generated or read.
enum class FootBoundary : unsigned int
{
  free = 0,
  stem_cut = 1,
  contact_zone = 2
};

/// How fine a generated foot mesh is. Counts are of cells.
struct FootResolution
{
  unsigned int azimuthal_cells = 48; ///< round the rim; a multiple of 4, at least 8
  unsigned int radial_cells = 4;     ///< across the land; even, so that r = contact_radius is a mesh line
  unsigned int foot_layers = 2;      ///< through the thickness of the foot

  /// Throws std::invalid_argument for counts that no mesh has.
  void validate() const;
};

/// Hexahedral mesh of @p profile: O-grid core under the stem, rings outside it, the land below, the stem
/// above. A multiple of 12 sectors lets the core have a third of them (one ring passes from 1 to 3 cells).
/// Cylindrical manifold outside the core's square, boundary ids as in FootBoundary. @p triangulation must be
/// empty.
void make_foot_mesh(const GlassProfile &profile, const FootResolution &resolution,
                    dealii::Triangulation<3, 3> &triangulation);

/// What was found in a mesh file.
struct MeshReport
{
  unsigned int n_cells = 0;
  unsigned int n_contact_faces = 0;
  bool round_rim =
    false; ///< rim vertices lie on circles to 1e-6 of the radius: the cylindrical manifold is attached
  double rim_radius = 0; ///< (inner + outer)/2 of the contact zone [m]
  double land_area_deficit =
    0; ///< share of the land's area that straight edges cut off, estimated from their turning; 0 if round
};

/// Reads a .msh file (hexahedra; boundary ids 1 = stem cut, 2 = contact zone, 0 or none = free) with the axis
/// of the glass along z. Throws std::invalid_argument with one sentence when the file is missing, not a
/// hexahedral mesh, or has no stem cut or contact zone.
MeshReport read_foot_mesh(const std::string &file_name, dealii::Triangulation<3, 3> &triangulation);

} // namespace stemware::fem
