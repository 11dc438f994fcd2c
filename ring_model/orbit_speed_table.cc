#include "ring_model/orbit_speed_table.h"

#include "ring_model/load/require.h"

// Boost 1.74 calls isnan() unqualified, so <math.h> must be included first.
// clang-format off
#include <math.h> // NOLINT(modernize-deprecated-headers)
#include <boost/math/interpolators/pchip.hpp>
// clang-format on

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <utility>

namespace stemware::ring
{
namespace
{
/// Adds two points to every interval of a polygon, at the fraction @p share of the interval from each end. A
/// cubic interpolant through all points then deviates from the polygon only near its corners.
void refine(std::vector<double> &times, std::vector<double> &speeds, double share)
{
  std::vector<double> t{ times[0] }, v{ speeds[0] };
  for (std::size_t i = 1; i < times.size(); ++i)
    for (const double place : { share, 1. - share, 1. })
    {
      t.push_back(times[i - 1] + (times[i] - times[i - 1]) * place);
      v.push_back(speeds[i - 1] + (speeds[i] - speeds[i - 1]) * place);
    }
  times = std::move(t);
  speeds = std::move(v);
}
} // namespace

OrbitSpeedTable::OrbitSpeedTable(std::vector<double> given_times, std::vector<double> given_speeds)
    : times(std::move(given_times))
    , speeds(std::move(given_speeds))
{
  require(times.size() == speeds.size() && times.size() >= 2, "the speed table has ", times.size(),
          " times and ", speeds.size(), " speeds, but must have equally many and at least two");
  for (std::size_t i = 0; i < times.size(); ++i)
  {
    require_finite(times[i], "a time of the speed table [s]");
    const bool is_at_rest = speeds[i] == 0. && (i == 0 || speeds[i - 1] == 0.);
    if (!is_at_rest || i + 1 == times.size())
      require_positive(speeds[i], "a speed of the speed table, after a rest at its beginning,", "m/s");
    require(i == 0 || times[i] > times[i - 1], "time ", i, " of the speed table is ", times[i], " s after ",
            i == 0 ? 0. : times[i - 1], " s, but times must increase");
  }
  std::vector<double> t = times, v = speeds;
  if (t.size() < 4)
    refine(t, v, 1. / 3.);
  knot_times = t;
  using Interpolant = boost::math::interpolators::pchip<std::vector<double>>;
  const auto cubic = std::make_shared<const Interpolant>(std::move(t), std::move(v));
  interpolant = [cubic](double time) { return (*cubic)(time); };
  slope = [cubic](double time) { return cubic->prime(time); };
}

OrbitSpeedTable OrbitSpeedTable::joined_by_lines() const
{
  std::vector<double> t = times, v = speeds;
  refine(t, v, 1e-3);
  return { std::move(t), std::move(v) };
}

void OrbitSpeedTable::check_range(double time) const
{
  if (!(time >= times.front() && time <= times.back()))
    throw std::out_of_range(sentence("the speed at t = ", time, " s was asked for, but the table covers ",
                                     times.front(), " to ", times.back(), " s: add entries"));
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
  now.orbit_speed = std::max(speed(time), 1e-9 * max_speed());
  now.orbit_acceleration = acceleration(time);
  return now;
}

double OrbitSpeedTable::max_speed() const
{
  return *std::max_element(speeds.begin(), speeds.end());
}

double OrbitSpeedTable::time_of(double speed) const
{
  const auto is_reached = [=](double other) { return other >= speed && other > 0.; };
  const auto entry = std::find_if(speeds.begin(), speeds.end(), is_reached);
  if (entry == speeds.end())
    throw std::out_of_range(sentence("the speed table does not reach ", speed, " m/s"));
  const auto i = static_cast<std::size_t>(entry - speeds.begin());
  if (i == 0 || speed <= 0.)
    return times[i == 0 ? 0 : i - 1];
  double before = times[i - 1], after = times[i];
  for (double middle = (before + after) / 2.; before < middle && middle < after;
       middle = (before + after) / 2.)
    (is_reached(interpolant(middle)) ? after : before) = middle;
  return after;
}
} // namespace stemware::ring
