#pragma once

#include "fem/geometry/boundary_ids.h"
#include "fem/geometry/foot_resolution.h"
#include "fem/geometry/triangulation.h"

namespace stemware::fem
{

/// Makes the hexahedral mesh of @p profile: O-grid core under the stem, rings around it, the land below, the
/// stem above. With a multiple of 12 sectors the core has a third of them (one ring changes from 1 to 3
/// cells). Halved cells keep their parents' shape. Cylindrical manifold outside the core's square; boundary
/// ids of FootBoundary. @p triangulation must be empty.
void make_foot_mesh(const GlassProfile &profile, const FootResolution &resolution,
                    dealii::Triangulation<3, 3> &triangulation);

} // namespace stemware::fem
