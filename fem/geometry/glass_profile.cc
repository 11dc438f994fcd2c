#include "fem/geometry/glass_profile.h"

#include "fem/geometry/meridian_section.h"
#include "fem/geometry/require.h"
#include "ring_model/load/constants.h"

#include <algorithm>
#include <cmath>

namespace stemware::fem
{

namespace
{
double square(double x)
{
  return x * x;
}

void require_positive(const char *name, double value)
{
  require(std::isfinite(value) && value > 0, name, " = ", value,
          " m is not a length of the glass; give a finite number greater than 0.");
}

/// Throws unless @p value is finite and not negative. The message ends with "0 for" @p meaning_of_zero.
void require_not_negative(const char *name, double value, const char *meaning_of_zero)
{
  require(std::isfinite(value) && value >= 0, name, " = ", value,
          " m is not a length of the glass; give a finite number greater than 0, or 0 for ", meaning_of_zero,
          '.');
}

void require_less(const char *name, double value, const char *limit_name, double limit)
{
  require(value < limit, name, " = ", value, " m does not fit the foot: it must be smaller than the ",
          limit_name, ", ", limit, " m; change one of the two.");
}
} // namespace

double GlassProfile::foot_top() const
{
  return (shape == GlassShape::step ? land_height : underside(stem_radius)) + foot_thickness;
}

double GlassProfile::height() const
{
  return shape == GlassShape::profile ? section->height() : foot_top() + stem_height;
}

double GlassProfile::outer_radius() const
{
  return shape == GlassShape::profile ? section->outer_radius() : foot_radius;
}

double GlassProfile::thickness() const
{
  return shape == GlassShape::profile ? section->thickness() : foot_thickness;
}

double GlassProfile::underside(double radius) const
{
  const double inner = land_inner_radius();
  const double outer = land_outer_radius();
  if (radius >= inner && radius <= outer)
    return 0;
  if (shape == GlassShape::profile)
  {
    const double border = radius < inner ? inner : outer;
    const double share = 1 - std::abs(radius - border) / (land_width / 2);
    return std::max(0., section->underside(radius) - std::max(0., share) * section->underside(border));
  }
  if (shape == GlassShape::step)
    return land_height;
  return radius < inner ? underside_rise * square(1 - square(radius / inner))
                        : land_height * square((radius - outer) / (foot_radius - outer));
}

double GlassProfile::cone_slope() const
{
  return (land_height + edge_thickness - foot_top()) / (foot_radius - stem_radius);
}

double GlassProfile::cone(double radius) const
{
  return foot_top() + cone_slope() * (radius - stem_radius);
}

Fillet GlassProfile::fillet() const
{
  Fillet fillet;
  if (shape == GlassShape::profile)
  {
    fillet.centre_radius = fillet.middle_radius = section->middle_radius();
    fillet.middle_height = section->middle_height();
    fillet.centre_height = section->stem_begin();
    // The land's inner border is a cell border, so the fillet must end at a smaller radius.
    const double end = section->fillet_end_radius();
    fillet.end_radius = end < 0.9 * land_inner_radius() ? end : fillet.middle_radius;
    return fillet;
  }
  if (shape == GlassShape::step || fillet_radius == 0)
  {
    fillet.centre_radius = fillet.middle_radius = fillet.end_radius = stem_radius;
    fillet.centre_height = fillet.middle_height = foot_top();
    return fillet;
  }
  // The arc touches the stem and the cone, so its centre has the distance fillet_radius from each. In polar
  // angle about the centre, the arc runs from -pi (stem) to tilt - pi/2 (cone).
  const double tilt = std::atan(cone_slope());
  const double middle = tilt / 2 - ring::pi * 3 / 4;
  fillet.radius = fillet_radius;
  fillet.centre_radius = stem_radius + fillet_radius;
  fillet.centre_height = cone(fillet.centre_radius) + fillet_radius / std::cos(tilt);
  fillet.middle_radius = fillet.centre_radius + fillet_radius * std::cos(middle);
  fillet.middle_height = fillet.centre_height + fillet_radius * std::sin(middle);
  fillet.end_radius = fillet.centre_radius + fillet_radius * std::sin(tilt);
  return fillet;
}

double GlassProfile::topside(double radius) const
{
  if (shape == GlassShape::profile)
    return radius < section->middle_radius() ? height() : section->topside(radius);
  if (radius < stem_radius)
    return height();
  if (shape == GlassShape::step)
    return foot_top();
  const Fillet arc = fillet();
  if (radius >= arc.end_radius)
    return cone(radius);
  return arc.centre_height - std::sqrt(square(arc.radius) - square(arc.centre_radius - radius));
}

double GlassProfile::stem_surface(double height) const
{
  if (shape == GlassShape::profile)
    return section->stem_surface(height);
  const Fillet arc = fillet();
  if (height >= arc.centre_height)
    return stem_radius;
  return arc.centre_radius - std::sqrt(square(arc.radius) - square(arc.centre_height - height));
}

double GlassProfile::gap(double radius) const
{
  if (crown_radius == 0)
    return 0;
  return square(radius - contact_radius) / (2 * crown_radius);
}

void GlassProfile::validate() const
{
  require_positive("Contact radius", contact_radius);
  require_positive("Land width", land_width);
  require_not_negative("Crown radius", crown_radius, "a flat land");
  if (shape == GlassShape::profile)
    return validate_section();
  require_positive("Foot radius", foot_radius);
  require_positive("Foot thickness", foot_thickness);
  require_positive("Land height", land_height);
  require_positive("Stem radius", stem_radius);
  require_positive("Stem height", stem_height);
  require_less("Stem radius", stem_radius, "inner radius of the land", land_inner_radius());
  require_less("The outer radius of the land, contact radius + land width / 2", land_outer_radius(),
               "foot radius", foot_radius);
  if (shape == GlassShape::foot)
    validate_foot();
}

void GlassProfile::validate_section() const
{
  require(section != nullptr, "A profile needs a section; name its points in a profile file.");
  require_less("Radius of the stem where it meets the foot", section->middle_radius(),
               "inner radius of the land", land_inner_radius());
  require_less("The outer radius of the land, contact radius + land width / 2", land_outer_radius(),
               "largest radius of the profile", section->outer_radius());
  const double tolerance = 1e-6 * section->outer_radius();
  for (const SectionVertex &vertex : section->points_below(tolerance))
    require(!(std::abs(vertex.radius - contact_radius) > 1.05 * land_width / 2),
            "The profile stands on the table at r = ", vertex.radius, " m (line ", vertex.line,
            "), outside its land from ", land_inner_radius(), " m to ", land_outer_radius(),
            " m; change the contact radius or the land width.");
}

void GlassProfile::validate_foot() const
{
  require_positive("Edge thickness", edge_thickness);
  require_not_negative("Underside rise", underside_rise, "a plane underside");
  require_not_negative("Fillet radius", fillet_radius, "a sharp corner");
  const Fillet arc = fillet();
  require(arc.end_radius < land_inner_radius(), "Fillet radius = ", fillet_radius,
          " m does not fit between stem and land: the rounding would end at a radius of ", arc.end_radius,
          " m, and the land begins at ", land_inner_radius(), " m; give a smaller one.");
  require(arc.centre_height < height(), "Fillet radius = ", fillet_radius, " m rounds the stem up to ",
          arc.centre_height - foot_top(), " m above the foot, beyond its cut at stem height = ", stem_height,
          " m; give a smaller fillet or a longer stem.");
  // The underside can rise above the top only between the axis and the land.
  constexpr unsigned int n_samples = 1000;
  for (unsigned int i = 0; i < n_samples; ++i)
  {
    const double radius = land_inner_radius() * i / n_samples;
    const double top = radius < arc.middle_radius ? arc.middle_height : topside(radius);
    require(underside(radius) < top, "Underside rise = ", underside_rise,
            " m leaves no thickness of glass at a radius of ", radius,
            " m; give a smaller rise or a larger foot thickness.");
  }
}

} // namespace stemware::fem
