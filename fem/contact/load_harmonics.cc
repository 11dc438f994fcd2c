#include "fem/contact/load_harmonics.h"

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace stemware::fem
{

namespace
{
/// Fourier sums of point forces. Points that follow each other on one azimuth line are taken together, and
/// cos and sin of n theta come from turning the point's direction: a law has thousands of points.
class AzimuthSums
{
public:
  explicit AzimuthSums(LoadHarmonics &load)
      : load(load)
  {
  }

  void add(double cosine_given, double sine_given, double force_given)
  {
    if (std::abs(cosine_given - cosine) + std::abs(sine_given - sine) > 1e-14)
    {
      flush();
      cosine = cosine_given;
      sine = sine_given;
    }
    force += force_given;
  }

  /// Brings the last line's force into the sums.
  void flush()
  {
    double even = force / boost::math::double_constants::pi;
    double odd = 0;
    for (std::size_t n = 0; n < load.a.size(); ++n)
    {
      load.a[n] += even;
      load.b[n] += odd;
      const double next = even * cosine - odd * sine;
      odd = even * sine + odd * cosine;
      even = next;
    }
    force = 0;
  }

private:
  LoadHarmonics &load;
  double cosine = 1;
  double sine = 0;
  double force = 0;
};
} // namespace

LoadHarmonics harmonics_of(const std::vector<PointForce> &forces, unsigned int n_harmonics)
{
  LoadHarmonics load;
  load.a.assign(n_harmonics + 1, 0);
  load.b.assign(n_harmonics + 1, 0);
  double first_radial_moment = 0;
  double second_radial_moment = 0;
  AzimuthSums sums(load);
  for (const PointForce &point : forces)
  {
    const double radius = std::sqrt(point.x * point.x + point.y * point.y);
    load.normal_force += point.force;
    load.moment_x += point.y * point.force;
    load.moment_y -= point.x * point.force;
    first_radial_moment += radius * point.force;
    second_radial_moment += radius * radius * point.force;
    if (radius > 0)
      sums.add(point.x / radius, point.y / radius, point.force);
    else
      sums.add(1, 0, point.force);
  }
  sums.flush();
  if (!(load.normal_force > 0))
    throw std::invalid_argument(
      "There is no load on the table, so there are no load harmonics; press the foot with a positive force.");
  load.a[0] /= 2;
  load.b[0] = 0;
  load.mean_radius = first_radial_moment / load.normal_force;
  const double moment = std::hypot(load.moment_x, load.moment_y);
  const double amplitude = n_harmonics > 0 ? std::hypot(load.a[1], load.b[1]) : 0;
  // Below rounding the quotient of moment and first harmonic is noise; the radius that it tends to is the one
  // without a moment.
  const bool has_moment = moment > 1e-10 * load.normal_force * load.mean_radius && amplitude > 0;
  load.ring_radius = has_moment ? moment / (boost::math::double_constants::pi * amplitude)
                                : second_radial_moment / first_radial_moment;
  return load;
}

LoadHarmonics extract_load(const TableLaw &law, const ContactSolution &solution, unsigned int n_harmonics)
{
  TableLoad on_table = law.load(solution.approach);
  LoadHarmonics load = harmonics_of(on_table.points, n_harmonics);
  load.pointwise = std::move(on_table.density);
  const auto less = [](const AzimuthLoad &one, const AzimuthLoad &other)
  { return one.density < other.density; };
  load.minimum = std::min_element(load.pointwise.begin(), load.pointwise.end(), less)->density;
  const auto n_loaded = std::count_if(load.pointwise.begin(), load.pointwise.end(),
                                      [](const AzimuthLoad &place) { return place.density > 0; });
  load.contact_fraction = static_cast<double>(n_loaded) / static_cast<double>(load.pointwise.size());
  return load;
}

ResolvedFriction resolved_friction(const std::vector<PointForce> &forces, double friction_coefficient,
                                   double omega, double speed)
{
  ResolvedFriction friction;
  for (const PointForce &point : forces)
  {
    const double slip_x = speed - omega * point.y;
    const double slip_y = omega * point.x;
    const double slip = std::hypot(slip_x, slip_y);
    if (slip == 0)
      continue;
    const double force_x = -friction_coefficient * point.force * slip_x / slip;
    const double force_y = -friction_coefficient * point.force * slip_y / slip;
    friction.force_x += force_x;
    friction.force_y += force_y;
    friction.torque += point.x * force_y - point.y * force_x;
  }
  return friction;
}

} // namespace stemware::fem
