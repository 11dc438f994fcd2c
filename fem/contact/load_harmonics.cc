#include "fem/contact/load_harmonics.h"

#include "fem/contact/sliding_traction.h"

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace stemware::fem
{

namespace
{

using boost::math::double_constants::pi;

/// Fourier sums of point forces on rings. Points that follow each other on one azimuth line are taken
/// together, and cos and sin of n theta come from turning the point's direction: a law has thousands of
/// points.
class AzimuthSums
{
public:
  AzimuthSums(std::size_t n_rings, unsigned int n_harmonics)
      : a(n_rings, std::vector<double>(n_harmonics + 1, 0))
      , b(a)
      , forces(n_rings, 0)
  {
  }

  /// Adds the force of @p point at @p radius, the share @p shares[j] of it to ring j.
  void add(const PointForce &point, double radius, const std::vector<double> &shares)
  {
    const double new_cosine = radius > 0 ? point.x / radius : 1;
    const double new_sine = radius > 0 ? point.y / radius : 0;
    if (std::abs(new_cosine - cosine) + std::abs(new_sine - sine) > 1e-14)
    {
      flush();
      cosine = new_cosine;
      sine = new_sine;
    }
    for (std::size_t j = 0; j < forces.size(); ++j)
      forces[j] += shares[j] * point.force;
  }

  /// Brings the last line's forces into the sums, and hands these over.
  void finish(LoadHarmonics &load)
  {
    flush();
    for (std::size_t j = 0; j < a.size(); ++j)
    {
      a[j][0] /= 2;
      b[j][0] = 0;
    }
    load.a = std::move(a);
    load.b = std::move(b);
  }

private:
  void flush()
  {
    for (std::size_t j = 0; j < forces.size(); ++j)
    {
      double even = forces[j] / pi;
      double odd = 0;
      for (std::size_t n = 0; n < a[j].size(); ++n)
      {
        a[j][n] += even;
        b[j][n] += odd;
        const double next = even * cosine - odd * sine;
        odd = even * sine + odd * cosine;
        even = next;
      }
      forces[j] = 0;
    }
  }

  std::vector<std::vector<double>> a;
  std::vector<std::vector<double>> b;
  std::vector<double> forces; ///< of the present line on each ring
  double cosine = 1;
  double sine = 0;
};

/// Lagrange polynomials of @p nodes at @p x into @p values.
void evaluate_lagrange(const std::vector<double> &nodes, double x, std::vector<double> &values)
{
  for (std::size_t j = 0; j < nodes.size(); ++j)
  {
    values[j] = 1;
    for (std::size_t k = 0; k < nodes.size(); ++k)
      if (k != j)
        values[j] *= (x - nodes[k]) / (nodes[j] - nodes[k]);
  }
}

void require_radii(const std::vector<double> &radii)
{
  bool usable = !radii.empty() && std::isfinite(radii.back());
  double before = 0;
  for (const double radius : radii)
  {
    usable = usable && radius > before;
    before = radius;
  }
  if (!usable)
    throw std::invalid_argument(
      "The rings' radii are not allowed; give positive numbers in ascending order.");
}

/// Radius of the one ring that carries both the moment and the first harmonic.
double ring_radius(const LoadHarmonics &load, double first_radial_moment, double second_radial_moment)
{
  const double moment = std::hypot(load.moment_x, load.moment_y);
  const double amplitude = load.n_harmonics() > 0 ? std::hypot(load.a[0][1], load.b[0][1]) : 0;
  // Below rounding the quotient of moment and first harmonic is noise; the radius that it tends to is the one
  // without a moment.
  const bool has_moment = moment > 1e-10 * load.normal_force * load.mean_radius && amplitude > 0;
  return has_moment ? moment / (pi * amplitude) : second_radial_moment / first_radial_moment;
}

/// On the rings @p radii; without any on the one of ring_radius().
LoadHarmonics sums_of(const std::vector<PointForce> &forces, unsigned int n_harmonics,
                      const std::vector<double> &radii)
{
  LoadHarmonics load;
  load.radii = radii;
  double first_radial_moment = 0;
  double second_radial_moment = 0;
  std::vector<double> shares(std::max<std::size_t>(radii.size(), 1), 1.);
  AzimuthSums sums(shares.size(), n_harmonics);
  for (const PointForce &point : forces)
  {
    const double radius = std::sqrt(point.x * point.x + point.y * point.y);
    load.normal_force += point.force;
    load.moment_x += point.y * point.force;
    load.moment_y -= point.x * point.force;
    first_radial_moment += radius * point.force;
    second_radial_moment += radius * radius * point.force;
    if (radii.size() > 1)
      evaluate_lagrange(radii, radius, shares);
    sums.add(point, radius, shares);
  }
  if (!(load.normal_force > 0))
    throw std::invalid_argument(
      "There is no load on the table, so there are no load harmonics; press the foot with a positive force.");
  sums.finish(load);
  load.mean_radius = first_radial_moment / load.normal_force;
  if (radii.empty())
    load.radii = { ring_radius(load, first_radial_moment, second_radial_moment) };
  return load;
}

} // namespace

LoadHarmonics LoadHarmonics::turned(double angle) const
{
  LoadHarmonics load = *this;
  for (std::size_t j = 0; j < n_rings(); ++j)
    for (std::size_t n = 1; n <= n_harmonics(); ++n)
    {
      const double turn = static_cast<double>(n) * angle;
      load.a[j][n] = a[j][n] * std::cos(turn) - b[j][n] * std::sin(turn);
      load.b[j][n] = a[j][n] * std::sin(turn) + b[j][n] * std::cos(turn);
    }
  for (AzimuthLoad &place : load.pointwise)
    place.azimuth += angle;
  load.moment_x = moment_x * std::cos(angle) - moment_y * std::sin(angle);
  load.moment_y = moment_x * std::sin(angle) + moment_y * std::cos(angle);
  return load;
}

LoadHarmonics harmonics_of(const std::vector<PointForce> &forces, unsigned int n_harmonics)
{
  return sums_of(forces, n_harmonics, {});
}

LoadHarmonics harmonics_of(const std::vector<PointForce> &forces, unsigned int n_harmonics,
                           const std::vector<double> &radii)
{
  require_radii(radii);
  return sums_of(forces, n_harmonics, radii);
}

LoadHarmonics extract_load(const TableLaw &law, const ContactSolution &solution, unsigned int n_harmonics)
{
  TableLoad on_table = law.load(solution);
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
    const Eigen::Vector2d force =
      coulomb_friction({ speed - omega * point.y, omega * point.x }, friction_coefficient * point.force);
    friction.force_x += force(0);
    friction.force_y += force(1);
    friction.torque += point.x * force(1) - point.y * force(0);
  }
  return friction;
}

} // namespace stemware::fem
