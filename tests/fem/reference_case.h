#pragma once

#include "fem/contact/load_harmonics.h"
#include "fem/geometry/glass_profile.h"

#include <cmath>

namespace stemware::fem_tests
{

/// The weight of the reference cases, 0.30 kg at 9.81 m/s^2 [N].
constexpr double weight = 2.943;

/// Resultants of a load with moment ratio @p m (of N R / 2) whose maximum lies at azimuth @p direction.
inline fem::ContactLoad load_at(double m, double direction = 0, double radius = 0.03)
{
  const double moment = m * weight * radius / 2;
  return { weight, moment * std::sin(direction), -moment * std::cos(direction) };
}

/// The flat foot of the reference: land 2 mm wide, no crown.
inline fem::GlassProfile flat_profile()
{
  fem::GlassProfile profile;
  profile.land_width = 0.002;
  profile.crown_radius = 0;
  return profile;
}

} // namespace stemware::fem_tests
