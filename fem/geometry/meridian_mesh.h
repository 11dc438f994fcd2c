#pragma once

#include "fem/geometry/contact_cells.h"
#include "fem/geometry/triangulation.h"

namespace stemware::fem
{

/// Makes the meridional section of the foot in (r, z), boundary ids as in FootBoundary (1 stem cut, 2 contact
/// zone, 0 elsewhere, the axis included). Contact cells: contact_cells(), each halved
/// MeridianResolution::refinements times; others have hanging nodes. @p triangulation must be empty.
void make_meridian_mesh(const GlassProfile &profile, const MeridianResolution &resolution,
                        dealii::Triangulation<2, 2> &triangulation);

/// Makes the meridional section of the table's disc, 0 <= r <= radius, -thickness <= z <= 0: id 1 on the
/// fixed bottom, 2 on the top under the land of @p profile, with the contact cells of the foot.
void make_meridian_mesh(const TableDisc &disc, const GlassProfile &profile,
                        const MeridianResolution &resolution, dealii::Triangulation<2, 2> &triangulation);

} // namespace stemware::fem
