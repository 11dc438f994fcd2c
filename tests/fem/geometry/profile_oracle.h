#pragma once

#include "fem/geometry/glass_profile.h"

#include <boost/math/quadrature/tanh_sinh.hpp>

#include <algorithm>
#include <cmath>
#include <functional>

namespace stemware::fem_tests
{

using namespace stemware::fem;

inline GlassProfile foot_profile()
{
  GlassProfile profile;
  profile.shape = GlassShape::foot;
  return profile;
}

/// Returns the distance of a boundary point from the nearest surface of the section, along r or z [m].
inline double distance_from_profile(const GlassProfile &profile, double radius, double height)
{
  const Fillet arc = profile.fillet();
  double distance = std::min(radius, std::abs(height - profile.height()));
  distance = std::min(distance, std::abs(height - profile.underside(radius)));
  distance = std::min(distance, std::abs(height - profile.topside(radius)));
  distance = std::min(distance, std::abs(radius - profile.foot_radius));
  if (height >= arc.middle_height)
    distance = std::min(distance, std::abs(radius - profile.stem_surface(height)));
  return distance;
}

/// Returns int weight(r) (topside - underside) dr, by quadrature between the radii where the profile is not
/// smooth.
inline double integral_over_section(const GlassProfile &profile, const std::function<double(double)> &weight)
{
  boost::math::quadrature::tanh_sinh<double> quadrature;
  const auto slice = [&](double radius)
  { return weight(radius) * (profile.topside(radius) - profile.underside(radius)); };
  double integral = 0;
  double begin = 0;
  for (const double end : { profile.stem_radius, profile.fillet().end_radius, profile.land_inner_radius(),
                            profile.land_outer_radius(), profile.foot_radius })
  {
    integral += quadrature.integrate(slice, begin, std::nextafter(end, 0.), 1e-14);
    begin = end;
  }
  return integral;
}

} // namespace stemware::fem_tests
