#include "fem/glass_profile.h"

#include <cmath>
#include <sstream>
#include <stdexcept>

namespace stemware::fem
{

namespace
{
void require_positive(const char *name, double value)
{
  if (std::isfinite(value) && value > 0)
    return;
  std::ostringstream message;
  message << name << " = " << value
          << " m is not a length of the glass; give a finite number greater than 0.";
  throw std::invalid_argument(message.str());
}

void require_less(const char *name, double value, const char *limit_name, double limit)
{
  if (value < limit)
    return;
  std::ostringstream message;
  message << name << " = " << value << " m does not fit the foot: it must be smaller than the " << limit_name
          << ", " << limit << " m; change one of the two.";
  throw std::invalid_argument(message.str());
}
} // namespace

double GlassProfile::gap(double radius) const
{
  if (crown_radius == 0)
    return 0;
  const double offset = radius - contact_radius;
  return offset * offset / (2 * crown_radius);
}

void GlassProfile::validate() const
{
  require_positive("Contact radius", contact_radius);
  require_positive("Foot radius", foot_radius);
  require_positive("Foot thickness", foot_thickness);
  require_positive("Land width", land_width);
  require_positive("Land height", land_height);
  require_positive("Stem radius", stem_radius);
  require_positive("Stem height", stem_height);
  if (crown_radius != 0)
    require_positive("Crown radius (0 means a flat land)", crown_radius);
  require_less("Stem radius", stem_radius, "inner radius of the land", land_inner_radius());
  require_less("Outer radius of the land", land_outer_radius(), "foot radius", foot_radius);
}

} // namespace stemware::fem
