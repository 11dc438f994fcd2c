#pragma once

#include "fem/geometry/contact_cells.h"

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

  /// Throws std::invalid_argument if a length is not positive and finite, or the glass does not stand on
  /// the disc.
  void validate(const GlassProfile &profile) const;
};

/// Meridional section of the foot in (r, z), boundary ids as in FootBoundary (1 stem cut, 2 contact zone, 0
/// elsewhere, the axis included). Its contact cells are those of contact_cells(), each halved
/// MeridianResolution::refinements times; the others follow by halving, with hanging nodes. @p triangulation
/// must be empty.
void make_meridian_mesh(const GlassProfile &profile, const MeridianResolution &resolution,
                        dealii::Triangulation<2, 2> &triangulation);

/// Meridional section of the table's disc, 0 <= r <= radius, -thickness <= z <= 0: id 1 on the held bottom, 2
/// on the part of the top under the land of @p profile, cut into the contact cells of the foot.
void make_meridian_mesh(const TableDisc &disc, const GlassProfile &profile,
                        const MeridianResolution &resolution, dealii::Triangulation<2, 2> &triangulation);

} // namespace stemware::fem
