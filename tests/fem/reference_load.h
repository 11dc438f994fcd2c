#pragma once

#include "fem/contact/contact_load.h"
#include "fem/contact/contact_newton.h"
#include "fem/contact/interface_law.h"
#include "fem/geometry/glass_profile.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace stemware::fem_tests
{

using namespace stemware::fem;

/// Weight of the reference cases, 0.30 kg at 9.81 m/s^2 [N].
constexpr double weight = 2.943;

/// Returns the resultants for the moment ratio @p m (unit N R / 2) with the maximum of the load at the
/// azimuth @p direction.
inline Resultants load_at(double m, double direction = 0, double radius = 0.03)
{
  const double moment = m * weight * radius / 2;
  return { weight, moment * std::sin(direction), -moment * std::cos(direction) };
}

inline GlassProfile flat_profile()
{
  GlassProfile profile;
  profile.land_width = 0.002;
  profile.crown_radius = 0;
  return profile;
}

/// Returns the largest difference of a_n / a_0 for n = 2 ... @p highest.
inline double largest_difference(const ContactLoad &one, const ContactLoad &other, unsigned int highest = 8)
{
  double largest = 0;
  for (unsigned int n = 2; n <= highest; ++n)
    largest = std::max(largest, std::abs(one.a(n) / one.a(0) - other.a(n) / other.a(0)));
  return largest;
}

template <typename Action>
ContactOutcome outcome_of(const Action &action)
{
  try
  {
    action();
  }
  catch (const ContactFailure &failure)
  {
    return failure.outcome;
  }
  return ContactOutcome::converged;
}

inline ContactStart from(const ContactSolution &solution)
{
  return { solution.motion, solution.normal_displacement };
}

/// Returns the law of a compliant @p interface, which needs no penalty stiffness.
inline std::unique_ptr<TableLaw> make_law(const InterfaceLaw &interface, const ContactSurface &surface)
{
  return interface.make(surface, 0);
}

} // namespace stemware::fem_tests
