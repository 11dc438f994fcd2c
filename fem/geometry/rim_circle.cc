#include "fem/geometry/rim_circle.h"

#include <Eigen/Dense>
#include <boost/math/constants/constants.hpp>
#include <boost/math/distributions/students_t.hpp>

#include <algorithm>
#include <cmath>

namespace stemware::fem
{

namespace
{

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

/// Scatter of this size is that of numbers in a file [m].
constexpr double rounding_of_points = 1e-9;

/// Points in halves of the land from the lowest one, so that all lengths are of one size.
struct LandPoints
{
  std::vector<Vector2d> places;      ///< each once
  std::vector<std::size_t> n_copies; ///< of each in the list, itself left out
};

/// From the axis, or wherever the polyline begins, outwards to its largest radius: the part of @p polyline
/// that has its lowest point.
std::vector<SectionVertex> underside_of(const std::vector<SectionVertex> &polyline, std::size_t lowest)
{
  const auto outermost =
    std::max_element(polyline.begin(), polyline.end(),
                     [](const SectionVertex &a, const SectionVertex &b) { return a.radius < b.radius; });
  return outermost - polyline.begin() >= static_cast<std::ptrdiff_t>(lowest)
           ? std::vector<SectionVertex>(polyline.begin(), outermost + 1)
           : std::vector<SectionVertex>(outermost, polyline.end());
}

/// All that the window can reach while the circle's lowest place moves.
LandPoints points_near(const SectionVertex &lowest, const std::vector<SectionVertex> &underside, double scale)
{
  LandPoints points;
  for (const SectionVertex &vertex : underside)
  {
    const Vector2d place = Vector2d(vertex.radius - lowest.radius, vertex.height - lowest.height) / scale;
    if (std::abs(place.x()) > 2 || place.y() > 1)
      continue;
    if (!points.places.empty() && (place - points.places.back()).norm() * scale <= 1e-6 * lowest.radius)
      ++points.n_copies.back();
    else
    {
      points.places.push_back(place);
      points.n_copies.push_back(0);
    }
  }
  return points;
}

/// A circle by the place of its lowest point and its curvature: (x, curvature, y).
using Circle = Vector3d;

/// The circle through the points within 1 of the origin, by least squares of x^2 + y^2 - 2 a x - 2 b y - c,
/// which is linear; nothing where they are too few, too flat, or bend downwards.
std::optional<Circle> algebraic_circle(const std::vector<Vector2d> &places)
{
  Eigen::MatrixX3d matrix(places.size(), 3); // 2 x, 2 y, 1
  Eigen::Index n = 0;
  for (const Vector2d &place : places)
    if (std::abs(place.x()) <= 1)
      matrix.row(n++) << 2 * place.x(), 2 * place.y(), 1;
  matrix.conservativeResize(n, 3);
  if (n < 3 || matrix.col(1).maxCoeff() < 1e-3 * (matrix.col(0).maxCoeff() - matrix.col(0).minCoeff()))
    return {};
  const Vector3d fit = matrix.colPivHouseholderQr().solve(matrix.leftCols<2>().rowwise().squaredNorm() / 4);
  const double radius_squared = fit(2) + fit.head<2>().squaredNorm();
  if (!(fit(1) > 0) || !(radius_squared > 0) || !fit.allFinite())
    return {};
  const double radius = std::sqrt(radius_squared);
  return Circle(std::clamp(fit(0), -0.5, 0.5), 1 / radius, fit(1) - radius);
}

/// How much a point counts, and the derivative by @p offset, its distance from the middle of the window.
struct Weight
{
  double value = 0, slope = 0;
};

Weight weight_at(double offset)
{
  constexpr double full = 0.85, none = 1.15;
  const double distance = std::abs(offset);
  if (distance <= full)
    return { 1, 0 };
  if (distance >= none)
    return {};
  const double rate = boost::math::double_constants::half_pi / (none - full);
  const double angle = rate * (distance - full);
  return { std::cos(angle) * std::cos(angle), -std::copysign(rate, offset) * std::sin(2 * angle) };
}

/// Distance of @p point from @p circle, positive outside, and its derivative by the circle.
double distance_from(const Circle &circle, const Vector2d &point, Vector3d &derivative)
{
  const double x = point.x() - circle(0), y = point.y() - circle(2), curvature = circle(1);
  const double half_square = (x * x + y * y) / 2, value = curvature * half_square - y;
  // Distance from the centre over the radius; the distance from the circle without a difference of large
  // numbers.
  const double ratio = std::sqrt(1 + 2 * curvature * value);
  derivative << -curvature * x / ratio,
    half_square / ratio - 2 * value * value / (ratio * (1 + ratio) * (1 + ratio)),
    (1 - curvature * y) / ratio;
  return 2 * value / (1 + ratio);
}

/// Sums over the points in the window of a circle.
struct NormalEquations
{
  Matrix3d matrix = Matrix3d::Zero();                            ///< sum w J J^T
  Matrix3d squared = Matrix3d::Zero(), cubed = Matrix3d::Zero(); ///< with w^2, w^3
  Matrix3d of_window = Matrix3d::Zero(); ///< what the window's motion with the circle adds to the matrix
  Vector3d right = Vector3d::Zero();     ///< sum w d J
  double weight = 0, weight_squared = 0, distance_squared = 0; ///< sum w, w^2, w d^2
  unsigned int n_points = 0;
};

NormalEquations normal_equations(const Circle &circle, const std::vector<Vector2d> &places)
{
  NormalEquations sums;
  Vector3d derivative;
  for (const Vector2d &place : places)
  {
    const auto [weight, slope] = weight_at(place.x() - circle(0));
    if (!(weight > 0))
      continue;
    const double distance = distance_from(circle, place, derivative);
    const Matrix3d square = derivative * derivative.transpose();
    sums.matrix += weight * square;
    sums.squared += weight * weight * square;
    sums.cubed += weight * weight * weight * square;
    sums.of_window.col(0) -= slope * distance * derivative;
    sums.right += weight * distance * derivative;
    sums.weight += weight;
    sums.weight_squared += weight * weight;
    sums.distance_squared += weight * distance * distance;
    ++sums.n_points;
  }
  return sums;
}

/// The circle of least squares whose window is its own; nothing where it has fewer than three points or bends
/// downwards.
std::optional<Circle> settled_circle(Circle circle, const std::vector<Vector2d> &places)
{
  constexpr unsigned int n_most = 200;
  constexpr double relaxation = 0.7; // points that come in on one side push the window to the other
  for (unsigned int i = 0; i < n_most; ++i)
  {
    const NormalEquations sums = normal_equations(circle, places);
    if (sums.n_points < 3)
      return {};
    const Vector3d step = relaxation * sums.matrix.fullPivLu().solve(sums.right);
    circle -= step;
    if (!circle.allFinite() || !(circle(1) > 0) || std::abs(circle(0)) > 1)
      return {};
    if (step.lpNorm<Eigen::Infinity>() < 1e-14 * std::max(1., circle(1)))
      break;
  }
  return circle;
}

/// Scatter, its degrees of freedom and the covariance, once the circle is known.
void add_errors(const Circle &circle, const std::vector<Vector2d> &places, double scale, RimCircle &rim)
{
  const NormalEquations sums = normal_equations(circle, places);
  const Matrix3d inverse = sums.matrix.inverse();
  // The weighted sum of squares is e^T M e of the points' errors e, M = W - W J (J^T W J)^-1 J^T W.
  const Matrix3d share = inverse * sums.squared;
  const double trace = sums.weight - share.trace();
  const double trace_of_square =
    sums.weight_squared - 2 * (inverse * sums.cubed).trace() + (share * share).trace();
  if (sums.n_points < 4 || !(trace > 1e-12) || !(trace_of_square > 0) || !inverse.allFinite())
    return;
  const double variance = sums.distance_squared / trace;
  rim.freedom = std::max(1., trace * trace / trace_of_square);
  rim.scatter = scale * std::sqrt(variance);
  const Matrix3d response = (sums.matrix + sums.of_window).inverse();
  // Student's factor: this many estimated standard deviations hold 68.3 %.
  constexpr double one_sigma = 0.84134474606854293;
  const double factor = boost::math::quantile(boost::math::students_t(rim.freedom), one_sigma);
  const Matrix3d covariance = factor * factor * variance * response * sums.squared * response.transpose();
  // The crown radius is scale / curvature.
  const double by_curvature = -scale / (circle(1) * circle(1));
  rim.covariance[0][0] = scale * scale * covariance(0, 0);
  rim.covariance[0][1] = rim.covariance[1][0] = scale * by_curvature * covariance(0, 1);
  rim.covariance[1][1] = by_curvature * by_curvature * covariance(1, 1);
}

} // namespace

bool RimCircle::has_scatter() const
{
  return scatter > rounding_of_points && (covariance[0][0] > 0 || covariance[1][1] > 0);
}

std::optional<RimCircle> fit_rim_circle(const std::vector<SectionVertex> &polyline, double land_width)
{
  if (polyline.empty())
    return {};
  const auto lowest =
    std::min_element(polyline.begin(), polyline.end(),
                     [](const SectionVertex &a, const SectionVertex &b) { return a.height < b.height; });
  const double scale = land_width / 2;
  const LandPoints points =
    points_near(*lowest, underside_of(polyline, static_cast<std::size_t>(lowest - polyline.begin())), scale);
  const std::optional<Circle> start = algebraic_circle(points.places);
  const std::optional<Circle> circle = start ? settled_circle(*start, points.places) : std::nullopt;
  if (!circle)
    return {};

  RimCircle rim;
  rim.contact_radius = lowest->radius + scale * (*circle)(0);
  rim.crown_radius = scale / (*circle)(1);
  Vector3d unused;
  for (std::size_t i = 0; i < points.places.size(); ++i)
  {
    const Vector2d &place = points.places[i];
    const double weight = weight_at(place.x() - (*circle)(0)).value;
    if (!(weight > 0))
      continue;
    rim.points.push_back({ lowest->radius + scale * place.x(), scale * (place.y() - (*circle)(2)),
                           -scale * distance_from(*circle, place, unused), weight });
    rim.n_repeated += points.n_copies[i];
  }
  add_errors(*circle, points.places, scale, rim);
  return rim;
}

} // namespace stemware::fem
