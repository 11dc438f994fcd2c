#include "fem/geometry/foot_resolution.h"

#include "fem/geometry/require.h"

namespace stemware::fem
{

void FootResolution::validate() const
{
  require(azimuthal_cells >= 8 && azimuthal_cells % 4 == 0, "Azimuthal cells = ", azimuthal_cells,
          " is not allowed; give a multiple of 4, at least 8.");
  require(radial_cells >= 2 && radial_cells % 2 == 0, "Radial cells = ", radial_cells,
          " is not allowed; give an even number, at least 2.");
  require(foot_layers >= 1, "Foot layers = ", foot_layers, " is not allowed; give at least 1.");
}

unsigned int edge_halvings_for(const GlassProfile &profile, bool table_is_hard)
{
  if (!table_is_hard || profile.crown_radius != 0)
    return 0;
  // At a step's right-angled edge the pressure is finite, so two halvings suffice. Next to a smooth underside
  // the pressure is singular and the contact is a few 0.01 mm wide, which needs five halvings.
  return profile.shape == GlassShape::step ? 2 : 5;
}

} // namespace stemware::fem
