#include "ring_model/rim_slip.h"

#include "ring_model/load/constants.h"

#include <algorithm>
#include <cmath>

namespace stemware::ring
{
std::vector<RimSlip> rim_slip(const Motion &motion, double radius, const RingStack &load, double omega)
{
  constexpr unsigned int n_places = 24;
  const double mean = motion.friction_at_rest() * load.a(0);
  std::vector<RimSlip> places;
  for (unsigned int i = 0; i < n_places; ++i)
  {
    const double theta = 2 * pi * i / n_places;
    const double slip_x = motion.orbit_speed - omega * radius * std::sin(theta),
                 slip_y = omega * radius * std::cos(theta), slip = std::hypot(slip_x, slip_y);
    const double share = slip > 0 ? -motion.friction_at(slip) * std::max(0., load(theta)) / (mean * slip) : 0;
    places.push_back(
      { theta, slip_x / motion.orbit_speed, slip_y / motion.orbit_speed, share * slip_x, share * slip_y });
  }
  return places;
}
} // namespace stemware::ring
