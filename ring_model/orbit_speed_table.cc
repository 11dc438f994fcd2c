#include "ring_model/orbit_speed_table.h"

#include "ring_model/require.h"

// Boost 1.74 calls isnan() unqualified: the C header has to come first.
// clang-format off
#include <math.h> // NOLINT(modernize-deprecated-headers)
#include <boost/math/interpolators/pchip.hpp>
// clang-format on

#include <memory>
#include <stdexcept>
#include <utility>

namespace stemware::ring
{
namespace
{
/// The polygon with two more points in every interval: the cubic through them is the polygon where it is
/// straight.
void refine(std::vector<double> &times, std::vector<double> &speeds)
{
  std::vector<double> t{ times[0] }, v{ speeds[0] };
  for (std::size_t i = 1; i < times.size(); ++i)
    for (unsigned int third = 1; third <= 3; ++third)
    {
      t.push_back(times[i - 1] + (times[i] - times[i - 1]) * third / 3.);
      v.push_back(speeds[i - 1] + (speeds[i] - speeds[i - 1]) * third / 3.);
    }
  times = std::move(t);
  speeds = std::move(v);
}
} // namespace

OrbitSpeedTable::OrbitSpeedTable(std::vector<double> times, std::vector<double> speeds)
    : first_time(0.)
    , last_time(0.)
{
  require(times.size() == speeds.size() && times.size() >= 2, "the speed table has ", times.size(),
          " times and ", speeds.size(), " speeds, but must have equally many and at least two");
  for (std::size_t i = 0; i < times.size(); ++i)
  {
    require_finite(times[i], "a time of the speed table [s]");
    require_positive(speeds[i], "a speed of the speed table", "m/s");
    require(i == 0 || times[i] > times[i - 1], "time ", i, " of the speed table is ", times[i], " s after ",
            i == 0 ? 0. : times[i - 1], " s, but times must increase");
  }
  first_time = times.front();
  last_time = times.back();
  if (times.size() < 4)
    refine(times, speeds);
  using Interpolant = boost::math::interpolators::pchip<std::vector<double>>;
  const auto cubic = std::make_shared<const Interpolant>(std::move(times), std::move(speeds));
  interpolant = [cubic](double time) { return (*cubic)(time); };
  slope = [cubic](double time) { return cubic->prime(time); };
}

void OrbitSpeedTable::check_range(double time) const
{
  if (!(time >= first_time && time <= last_time))
    throw std::out_of_range(sentence("the speed at t = ", time, " s was asked for, but the table covers ",
                                     first_time, " to ", last_time, " s: add entries"));
}

double OrbitSpeedTable::speed(double time) const
{
  check_range(time);
  return interpolant(time);
}

double OrbitSpeedTable::acceleration(double time) const
{
  check_range(time);
  return slope(time);
}

Motion OrbitSpeedTable::motion_at(const Motion &motion, double time) const
{
  Motion now = motion;
  now.orbit_speed = speed(time);
  now.orbit_acceleration = acceleration(time);
  return now;
}
} // namespace stemware::ring
