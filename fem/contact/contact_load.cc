#include "fem/contact/contact_load.h"

#include "ring_model/load/constants.h"

#include <boost/math/tools/minima.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace stemware::fem
{

namespace
{

using ring::pi;

/// Fourier sums and moments of point forces on rings. Consecutive points on the same azimuth line are summed
/// first, so that cos n theta and sin n theta are evaluated only once per line.
class AzimuthSums
{
public:
  /// Sums of f, f y, -f x, f r, f r^2 over the point forces f.
  using Moments = Eigen::Matrix<double, 5, 1>;

  AzimuthSums(const std::vector<double> &radii, unsigned int n_harmonics)
      : shares(radii)
      , of_rings(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(radii.size())))
  {
    const std::vector<double> zeros(n_harmonics + 1, 0);
    for (const double radius : radii)
      rings.push_back({ radius, zeros, zeros });
  }

  void add(const PointForce &point)
  {
    double radius = point.x * cosine + point.y * sine;
    if (!(std::abs(point.y * cosine - point.x * sine) <= 1e-14 * radius))
    {
      flush();
      radius = std::hypot(point.x, point.y);
      cosine = radius > 0 ? point.x / radius : 1;
      sine = radius > 0 ? point.y / radius : 0;
    }
    on_line += Eigen::Vector3d(1, radius, radius * radius) * point.force;
    of_rings += point.force * shares.at(radius);
  }

  void finish(const SurfaceParts &parts)
  {
    flush();
    sums = parts.sum(sums);
    for (ring::RingStack::Ring &ring : rings)
    {
      parts.sum_in_place(ring.a);
      parts.sum_in_place(ring.b);
      ring.a[0] /= 2;
      ring.b[0] = 0;
    }
  }

  Moments sums = Moments::Zero();
  std::vector<ring::RingStack::Ring> rings;

private:
  void flush()
  {
    sums +=
      (Moments() << on_line(0), on_line(1) * sine, -on_line(1) * cosine, on_line(1), on_line(2)).finished();
    on_line.setZero();
    for (std::size_t j = 0; j < rings.size(); ++j)
    {
      double even = of_rings(static_cast<Eigen::Index>(j)) / pi;
      double odd = 0;
      for (std::size_t n = 0; n < rings[j].a.size(); ++n)
      {
        rings[j].a[n] += even;
        rings[j].b[n] += odd;
        const double next = even * cosine - odd * sine;
        odd = even * sine + odd * cosine;
        even = next;
      }
    }
    of_rings.setZero();
  }

  const RingWeights shares;
  Eigen::Vector3d on_line = Eigen::Vector3d::Zero(); ///< sums of f, f r, f r^2 on the current line
  Eigen::VectorXd of_rings;                          ///< force of the current line on each ring
  double cosine = 1;
  double sine = 0;
};

bool are_equidistant(const std::vector<AzimuthValue> &pointwise)
{
  const double step = 2 * pi / static_cast<double>(pointwise.size());
  for (std::size_t i = 1; i < pointwise.size(); ++i)
    if (std::abs(pointwise[i].azimuth - pointwise.front().azimuth - static_cast<double>(i) * step) >
        1e-9 * step)
      return false;
  return true;
}

/// Returns the trigonometric interpolant of values at equidistant azimuths, in barycentric form (Henrici,
/// Essentials of Numerical Analysis, 1982, section 6).
double trigonometric_value(const std::vector<AzimuthValue> &pointwise, double azimuth)
{
  double above = 0, below = 0, sign = 1;
  for (const AzimuthValue &at : pointwise)
  {
    const double half = (azimuth - at.azimuth) / 2, sine = std::sin(half);
    if (sine == 0)
      return at.value;
    const double weight = sign / (pointwise.size() % 2 == 0 ? std::tan(half) : sine);
    above += weight * at.value;
    below += weight;
    sign = -sign;
  }
  return above / below;
}

} // namespace

RingWeights::RingWeights(std::vector<double> radii_given)
    : radii(std::move(radii_given))
    , per_unit(radii.size() > 1 ? 4 / (radii.back() - radii.front()) : 1)
    , factors(Eigen::VectorXd::Ones(static_cast<Eigen::Index>(radii.size())))
    , shares(factors)
{
  const auto is_not_below = [](double one, double other) { return !(one < other); };
  if (radii.empty() || !(radii.front() > 0) || !std::isfinite(radii.back()) ||
      std::adjacent_find(radii.begin(), radii.end(), is_not_below) != radii.end())
    throw std::invalid_argument(
      "The rings' radii are not allowed; give positive numbers in ascending order.");
  for (std::size_t j = 0; j < radii.size(); ++j)
    for (std::size_t k = 0; k < radii.size(); ++k)
      if (k != j)
        factors(static_cast<Eigen::Index>(j)) /= (radii[j] - radii[k]) * per_unit;
}

const Eigen::VectorXd &RingWeights::at(double radius) const
{
  shares = factors;
  double inside = 1, outside = 1; // products of the distances to the rings on the inner and the outer side
  for (std::size_t j = 0, k = radii.size() - 1; j < radii.size(); ++j, --k)
  {
    shares(static_cast<Eigen::Index>(j)) *= inside;
    inside *= (radius - radii[j]) * per_unit;
    shares(static_cast<Eigen::Index>(k)) *= outside;
    outside *= (radius - radii[k]) * per_unit;
  }
  // Far outside the rings, Lagrange polynomials would amplify rounding errors. Linear weights, which also
  // give exact force and moment, replace them there.
  constexpr double max_extrapolation = 1e6;
  const bool is_between = radius >= radii.front() && radius <= radii.back();
  if (!is_between && radii.size() > 2 && shares.lpNorm<1>() > max_extrapolation)
  {
    const double share = (radius - radii.front()) / (radii.back() - radii.front());
    shares.setZero();
    shares(0) = 1 - share;
    shares.tail<1>()(0) = share;
  }
  return shares;
}

ContactLoad ContactLoad::rotated(double angle) const
{
  ContactLoad load = *this;
  static_cast<RingStack &>(load) = RingStack::rotated(angle);
  for (AzimuthValue &place : load.pointwise)
    place.azimuth += angle;
  return load;
}

ContactLoad harmonics_of(const std::vector<PointForce> &forces, unsigned int n_harmonics,
                         const std::vector<double> &radii, const SurfaceParts &parts)
{
  AzimuthSums sums(radii.empty() ? std::vector<double>{ 1 } : radii, n_harmonics);
  for (const PointForce &point : forces)
    sums.add(point);
  sums.finish(parts);
  const AzimuthSums::Moments &moments = sums.sums;
  if (!(moments(0) > 0))
    throw std::invalid_argument("There is no load on the table, so there are no load harmonics.");
  const double mean_radius = moments(3) / moments(0);
  std::vector<ring::RingStack::Ring> rings = std::move(sums.rings);
  if (radii.empty())
    rings.front().radius = moments(4) / moments(3);
  double rotation = 0;
  const double moment = std::hypot(moments(1), moments(2));
  const double even = n_harmonics > 0 ? rings.front().a[1] : 0,
               odd = n_harmonics > 0 ? rings.front().b[1] : 0;
  // A moment at rounding level has no defined direction, nor a defined ratio to the first harmonic.
  if (radii.empty() && moment > 1e-10 * moments(0) * mean_radius && (even != 0 || odd != 0))
  {
    rings.front().radius = moment / (pi * std::hypot(even, odd));
    rotation = std::remainder(std::atan2(moments(1), -moments(2)) - std::atan2(odd, even), 2 * pi);
  }
  ring::RingStack stack(std::move(rings));
  ContactLoad load(rotation == 0 ? stack : stack.rotated(rotation));
  load.rotation = rotation;
  load.mean_radius = mean_radius;
  return load;
}

double least_load(const std::vector<AzimuthValue> &pointwise)
{
  const auto less = [](const AzimuthValue &one, const AzimuthValue &other)
  { return one.value < other.value; };
  const auto least = std::min_element(pointwise.begin(), pointwise.end(), less);
  if (!(least->value > 0) || pointwise.size() < 3)
    return std::max(0., least->value);
  const AzimuthValue &before = least == pointwise.begin() ? pointwise.back() : *(least - 1);
  const AzimuthValue &after = least + 1 == pointwise.end() ? pointwise.front() : *(least + 1);
  const auto distance = [](double angle) { return angle < 0 ? angle + 2 * pi : angle; };
  const double to_before = distance(least->azimuth - before.azimuth),
               to_after = distance(after.azimuth - least->azimuth);
  if (!(to_before > 0) || !(to_after > 0))
    return least->value;
  if (are_equidistant(pointwise))
  {
    const auto value = [&](double azimuth) { return trigonometric_value(pointwise, azimuth); };
    const double between =
      boost::math::tools::brent_find_minima(value, least->azimuth - to_before, least->azimuth + to_after,
                                            std::numeric_limits<double>::digits / 2)
        .second;
    return std::clamp(between, 0., least->value);
  }
  // Parabola least + slope t + bend t^2 through the three values; t: azimuth relative to `least`.
  const double fall = (before.value - least->value) / to_before,
               rise = (after.value - least->value) / to_after;
  const double bend = (rise + fall) / (to_before + to_after), slope = rise - bend * to_after;
  return bend > 0 ? std::max(0., least->value - slope * slope / (4 * bend)) : least->value;
}

unsigned int n_line_parts(std::size_t n_rings)
{
  // Four Gauss points are exact for polynomials of degree 7, the degree of the interpolation with 8 rings.
  // With 25 rings (nine parts), on a line twice as long as the contact width, radial moments of order 12 are
  // accurate to 1e-4, and radial moments of order 24 to 1 %.
  constexpr std::size_t max_rings_of_four_points = 8;
  return n_rings <= max_rings_of_four_points ? 1 : static_cast<unsigned int>(n_rings / 3 + 1);
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

ContactLoad extract_load(const TableLaw &law, const ContactSolution &solution, unsigned int n_harmonics,
                         const std::vector<double> &ring_radii)
{
  TableLoad on_table = law.load(solution, n_line_parts(ring_radii.size()));
  ContactLoad load = harmonics_of(on_table.points, n_harmonics, ring_radii, on_table.parts);
  load.pointwise = std::move(on_table.density);
  load.least = least_load(load.pointwise);
  const ContactExtent extent = law.extent(solution);
  load.contact_fraction = extent.area_share;
  load.azimuth_fraction = extent.azimuth_share;
  load.peak_pressure = extent.peak_pressure;
  return load;
}

} // namespace stemware::fem
