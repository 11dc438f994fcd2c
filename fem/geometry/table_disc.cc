#include "fem/geometry/table_disc.h"

#include "fem/geometry/require.h"

#include <cmath>

namespace stemware::fem
{

void TableDisc::validate(const GlassProfile &profile) const
{
  require(std::isfinite(thickness) && thickness > 0, "Disc thickness = ", thickness,
          " m is not allowed; give a finite number greater than 0.");
  require(std::isfinite(radius) && radius > profile.land_outer_radius(), "Disc radius = ", radius,
          " m is not allowed; it must be larger than the outer radius of the land, ",
          profile.land_outer_radius(), " m.");
}

} // namespace stemware::fem
