#include "ring_model/liquid.h"

#include "ring_model/load/constants.h"
#include "ring_model/load/require.h"

namespace stemware::ring
{
double Liquid::level() const
{
  return mass / (density * pi * bowl_radius * bowl_radius);
}

double Liquid::centre_height(double slope) const
{
  return bowl_height + level() / 2. + metacentric_radius() * slope * slope / 2.;
}

double Liquid::metacentric_radius() const
{
  return mass > 0. && surface_leans ? bowl_radius * bowl_radius / (4. * level()) : 0.;
}

void Liquid::validate(double slope) const
{
  require(std::isfinite(mass) && mass >= 0., "the mass of the liquid is ", mass,
          " kg, but must be finite and not negative");
  if (mass == 0.)
    return;
  require_positive(density, "the density of the liquid", "kg/m^3");
  require_positive(bowl_radius, "the radius of the bowl", "m");
  require_positive(bowl_depth, "the depth of the bowl", "m");
  require(std::isfinite(bowl_height) && bowl_height >= 0., "the bottom of the bowl is ", bowl_height,
          " m above the table, but must be at a finite height that is not negative");
  const double rise = surface_leans ? slope * bowl_radius : 0.;
  const auto shown = [](double length) { return std::round(length * 1e5) / 1e5; };
  require(level() + rise <= bowl_depth, "the bowl overflows: the liquid reaches ", shown(level() + rise),
          " m above its bottom (", shown(level()), " m when level), but the bowl is ", bowl_depth,
          " m deep; give less liquid, a lower speed or a larger bowl");
  require(rise <= level(), "the liquid leans so much that its surface meets the bottom of the bowl: it is ",
          shown(level()), " m deep when level and ", shown(rise),
          " m less at the wall; give more liquid, a lower speed or a narrower bowl");
}
} // namespace stemware::ring
