#include "fem/contact/load_harmonics.h"

#include "fem/contact/sliding_traction.h"

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>

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
  void add(const PointForce &point, double radius, const Eigen::VectorXd &shares)
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
      forces[j] += shares(static_cast<Eigen::Index>(j)) * point.force;
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

/// On the rings @p radii; without any on the one of ring_radius(). @p forces of a part of the surface.
LoadHarmonics sums_of(const std::vector<PointForce> &forces, unsigned int n_harmonics,
                      const std::vector<double> &radii, const SurfaceParts &parts = {})
{
  LoadHarmonics load;
  load.radii = radii;
  using Moments = Eigen::Matrix<double, 5, 1>;
  Moments moments = Moments::Zero();
  const std::optional<RingShares> shares = radii.empty() ? std::nullopt : std::optional(RingShares(radii));
  const Eigen::VectorXd whole = Eigen::VectorXd::Ones(1);
  AzimuthSums sums(std::max<std::size_t>(radii.size(), 1), n_harmonics);
  for (const PointForce &point : forces)
  {
    const double radius = std::sqrt(point.x * point.x + point.y * point.y);
    moments += point.force * Moments(1, point.y, -point.x, radius, radius * radius);
    sums.add(point, radius, shares ? shares->at(radius) : whole);
  }
  moments = parts.sum(moments);
  load.normal_force = moments(0);
  load.moment_x = moments(1);
  load.moment_y = moments(2);
  const double first_radial_moment = moments(3), second_radial_moment = moments(4);
  if (!(load.normal_force > 0))
    throw std::invalid_argument(
      "There is no load on the table, so there are no load harmonics; press the foot with a positive force.");
  sums.finish(load);
  for (auto *coefficients : { &load.a, &load.b })
    for (std::vector<double> &ring : *coefficients)
      parts.sum_in_place(ring);
  load.mean_radius = first_radial_moment / load.normal_force;
  if (radii.empty())
    load.radii = { ring_radius(load, first_radial_moment, second_radial_moment) };
  return load;
}

} // namespace

double LoadFunction::operator()(const LoadHarmonics &load) const
{
  double value = 0;
  for (std::size_t j = 0; j < a.size(); ++j)
    for (std::size_t n = 0; n < std::min(a[j].size(), load.a[j].size()); ++n)
      value += a[j][n] * load.a[j][n] + b[j][n] * load.b[j][n];
  return value;
}

LoadFunction LoadFunction::of_turned(double angle) const
{
  LoadFunction result = *this;
  for (std::size_t j = 0; j < a.size(); ++j)
    for (std::size_t n = 0; n < a[j].size(); ++n)
    {
      const double cosine = std::cos(static_cast<double>(n) * angle),
                   sine = std::sin(static_cast<double>(n) * angle);
      result.a[j][n] = a[j][n] * cosine + b[j][n] * sine;
      result.b[j][n] = b[j][n] * cosine - a[j][n] * sine;
    }
  return result;
}

LoadFunction operator*(double factor, LoadFunction function)
{
  for (auto *part : { &function.a, &function.b })
    for (std::vector<double> &ring : *part)
      for (double &coefficient : ring)
        coefficient *= factor;
  return function;
}

LoadFunction operator+(LoadFunction one, const LoadFunction &other)
{
  for (std::size_t j = 0; j < one.a.size(); ++j)
    for (std::size_t n = 0; n < one.a[j].size(); ++n)
    {
      one.a[j][n] += other.a[j][n];
      one.b[j][n] += other.b[j][n];
    }
  return one;
}

RingShares::RingShares(std::vector<double> radii_given)
    : radii(std::move(radii_given))
    , unit(radii.size() > 1 ? (radii.back() - radii.front()) / 4 : 1)
    , denominators(radii.size(), 1.)
    , shares(static_cast<Eigen::Index>(radii.size()))
{
  require_radii(radii);
  for (std::size_t j = 0; j < radii.size(); ++j)
    for (std::size_t k = 0; k < radii.size(); ++k)
      if (k != j)
        denominators[j] *= (radii[j] - radii[k]) / unit;
}

const Eigen::VectorXd &RingShares::at(double radius) const
{
  for (std::size_t j = 0; j < radii.size(); ++j)
  {
    double product = 1;
    for (std::size_t k = 0; k < radii.size(); ++k)
      if (k != j)
        product *= (radius - radii[k]) / unit;
    shares(static_cast<Eigen::Index>(j)) = product / denominators[j];
  }
  return shares;
}

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

double least_load(const std::vector<AzimuthLoad> &pointwise)
{
  const auto less = [](const AzimuthLoad &one, const AzimuthLoad &other)
  { return one.density < other.density; };
  const auto least = std::min_element(pointwise.begin(), pointwise.end(), less);
  if (!(least->density > 0) || pointwise.size() < 3)
    return std::max(0., least->density);
  const AzimuthLoad &before = least == pointwise.begin() ? pointwise.back() : *(least - 1);
  const AzimuthLoad &after = least + 1 == pointwise.end() ? pointwise.front() : *(least + 1);
  const auto distance = [](double angle) { return angle < 0 ? angle + 2 * pi : angle; };
  const double to_before = distance(least->azimuth - before.azimuth),
               to_after = distance(after.azimuth - least->azimuth);
  if (!(to_before > 0) || !(to_after > 0))
    return least->density;
  // The parabola least + slope t + bend t^2 through the three.
  const double fall = (before.density - least->density) / to_before,
               rise = (after.density - least->density) / to_after;
  const double bend = (rise + fall) / (to_before + to_after), slope = rise - bend * to_after;
  return bend > 0 ? std::max(0., least->density - slope * slope / (4 * bend)) : least->density;
}

LoadHarmonics harmonics_on_lines(const Eigen::MatrixXd &forces, const Eigen::VectorXd &radii,
                                 unsigned int n_harmonics, const std::vector<double> &ring_radii)
{
  const Eigen::Index n_lines = forces.cols();
  const double width = 2 * pi / static_cast<double>(n_lines);
  const Eigen::RowVectorXd on_lines = forces.colwise().sum();
  LoadHarmonics load;
  load.normal_force = on_lines.sum();
  if (!(load.normal_force > 0))
    throw std::invalid_argument("There is no load on the table, so there are no load harmonics.");

  // Samples on the lines: the load of each ring, or of all, and its first radial moment.
  Eigen::MatrixXd samples(1, n_lines);
  samples.row(0) = on_lines;
  if (!ring_radii.empty())
  {
    const RingShares shares(ring_radii);
    Eigen::MatrixXd of_circles(ring_radii.size(), radii.size());
    for (Eigen::Index i = 0; i < radii.size(); ++i)
      of_circles.col(i) = shares.at(radii(i));
    samples = of_circles * forces;
  }
  const Eigen::RowVectorXd moment = radii.transpose() * forces;
  const double second_moment = radii.cwiseAbs2().dot(forces.rowwise().sum());

  // cos and sin of n theta_j repeat with n j modulo the number of lines.
  Eigen::VectorXd cosines(n_lines), sines(n_lines);
  for (Eigen::Index k = 0; k < n_lines; ++k)
  {
    cosines(k) = std::cos(width * static_cast<double>(k));
    sines(k) = std::sin(width * static_cast<double>(k));
  }
  load.moment_x = moment * sines;
  load.moment_y = -(moment * cosines).value();
  Eigen::MatrixXd even(n_lines, n_harmonics + 1), odd(n_lines, n_harmonics + 1);
  for (Eigen::Index n = 0; n <= n_harmonics; ++n)
    for (Eigen::Index j = 0; j < n_lines; ++j)
    {
      even(j, n) = cosines(n * j % n_lines);
      odd(j, n) = sines(n * j % n_lines);
    }
  const Eigen::MatrixXd a = samples * even / pi;
  const Eigen::MatrixXd b = samples * odd / pi;
  for (Eigen::Index j = 0; j < samples.rows(); ++j)
  {
    load.a.emplace_back(n_harmonics + 1);
    load.b.emplace_back(n_harmonics + 1);
    for (unsigned int n = 0; n <= n_harmonics; ++n)
    {
      load.a.back()[n] = n == 0 ? a(j, 0) / 2 : a(j, n);
      load.b.back()[n] = n == 0 ? 0 : b(j, n);
    }
  }
  load.mean_radius = moment.sum() / load.normal_force;
  load.radii = ring_radii;
  if (ring_radii.empty())
    load.radii = { ring_radius(load, moment.sum(), second_moment) };

  unsigned int n_loaded = 0;
  const double threshold = 1e-11 * on_lines.maxCoeff(); // of rounding
  for (Eigen::Index j = 0; j < n_lines; ++j)
  {
    load.pointwise.push_back({ width * static_cast<double>(j), on_lines(j) / width });
    n_loaded += on_lines(j) > threshold ? 1 : 0;
  }
  load.minimum = least_load(load.pointwise);
  load.contact_fraction = n_loaded / static_cast<double>(n_lines);
  return load;
}

unsigned int parts_of_lines(std::size_t n_rings)
{
  // Four Gauss points are exact for degree 7; nine parts of a line that is twice as long as the contact is
  // wide know the moment of the order 12 to 1e-4, that of the order 24 to a per cent.
  constexpr std::size_t known_by_four_points = 8;
  return n_rings <= known_by_four_points ? 1 : static_cast<unsigned int>(n_rings / 3 + 1);
}

std::pair<double, double> loaded_band(const TableLoad &load)
{
  double largest = 0;
  for (const PointForce &point : load.points)
    largest = std::max(largest, point.force);
  largest = load.parts.max(largest);
  double inner = std::numeric_limits<double>::infinity(), outer = 0;
  for (const PointForce &point : load.points)
    if (point.force > 1e-9 * largest)
    {
      const double radius = std::hypot(point.x, point.y);
      inner = std::min(inner, radius);
      outer = std::max(outer, radius);
    }
  return { load.parts.min(inner), load.parts.max(outer) };
}

LoadHarmonics extract_load(const TableLaw &law, const ContactSolution &solution, unsigned int n_harmonics,
                           const std::vector<double> &ring_radii)
{
  TableLoad on_table = law.load(solution, parts_of_lines(ring_radii.size()));
  LoadHarmonics load = sums_of(on_table.points, n_harmonics, ring_radii, on_table.parts);
  load.pointwise = std::move(on_table.density);
  load.minimum = least_load(load.pointwise);
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
