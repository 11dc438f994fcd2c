#pragma once

#include "fem/geometry/glass_profile.h"

namespace dealii
{
template <int dim, int spacedim>
class Triangulation;
}

namespace stemware::fem
{

/// Thick disc under the glass, a body of revolution about the axis of the ring: its upper side is the table,
/// its bottom is held.
struct TableDisc
{
  double radius = 0.150;    ///< [m], larger than the land's outer radius
  double thickness = 0.050; ///< [m]

  /// Throws std::invalid_argument when a length is not positive and finite or the glass does not stand on the
  /// disc.
  void validate(const GlassProfile &profile) const;
};

/// How fine a meridional mesh is. The contact cells depend on the land alone, so that a foot and a disc of
/// equal resolution share them.
struct MeridianResolution
{
  unsigned int land_cells = 4; ///< across the land, even; before any refinement
  double land_grading =
    3; ///< size ratio of neighbours on the land, finest at the contact radius; 1 means equal cells
  unsigned int refinements = 0; ///< halvings of every cell
  unsigned int focus_levels =
    0; ///< further halvings (hanging nodes) of the cells around the point (focus_radius, z = 0)
  double focus_radius = 0; ///< [m]; 0 means the contact radius

  /// Throws std::invalid_argument for counts and ratios that no mesh has.
  void validate() const;
};

/// Meridional section of the foot in (r, z), boundary ids as in FootBoundary (1 stem cut, 2 contact zone, 0
/// elsewhere, the axis included).
/// @p triangulation must be empty.
void make_meridian_mesh(const GlassProfile &profile, const MeridianResolution &resolution,
                        dealii::Triangulation<2, 2> &triangulation);

/// Meridional section of the table's disc, 0 <= r <= radius, -thickness <= z <= 0: id 1 on the held bottom, 2
/// on the part of the top under the land of @p profile, cut into the same contact cells as the foot.
void make_meridian_mesh(const TableDisc &disc, const GlassProfile &profile,
                        const MeridianResolution &resolution, dealii::Triangulation<2, 2> &triangulation);

} // namespace stemware::fem
