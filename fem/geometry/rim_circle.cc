#include "fem/geometry/rim_circle.h"

#include "ring_model/load/constants.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace stemware::fem
{

namespace
{

using Eigen::Vector2d;
using Eigen::Vector3d;

/// Returns the points of the underside (from the axis to the largest radius) within one land width of @p
/// lowest, relative to @p lowest and in units of @p half_land.
std::vector<Vector2d> points_near(std::vector<SectionVertex>::const_iterator lowest,
                                  const std::vector<SectionVertex> &polyline, double half_land)
{
  const auto is_inside = [](const auto &a, const auto &b) { return a.radius < b.radius; };
  const auto outermost = std::max_element(polyline.begin(), polyline.end(), is_inside);
  const bool is_before = lowest <= outermost;
  const auto end = is_before ? outermost + 1 : polyline.end();
  std::vector<Vector2d> points;
  for (auto x = is_before ? polyline.begin() : outermost; x != end; ++x)
  {
    const Vector2d point = Vector2d(x->radius - lowest->radius, x->height - lowest->height) / half_land;
    const bool is_repeated =
      !points.empty() && (point - points.back()).norm() * half_land <= 1e-6 * lowest->radius;
    if (std::abs(point.x()) <= 2 && point.y() <= 1 && !is_repeated)
      points.push_back(point);
  }
  return points;
}

/// Returns the weight of a point in the fit. @p offset: radial distance from the circle's lowest point in
/// half land widths. The weight is 1 up to `full`, 0 from `none` on, and smooth in between.
double weight_at(double offset)
{
  constexpr double full = 0.85, none = 1.15;
  const double share = std::clamp((std::abs(offset) - full) / (none - full), 0., 1.);
  return share < 1 ? std::pow(std::cos(ring::pi / 2 * share), 2) : 0;
}

/// Returns the signed distance of @p point from @p circle, positive outside. @p circle is (x of the lowest
/// point, curvature, y of the lowest point). @p derivative is the gradient with respect to @p circle.
double distance_from(const Vector3d &circle, const Vector2d &point, Vector3d &derivative)
{
  const double x = point.x() - circle(0), y = point.y() - circle(2), curvature = circle(1);
  const double half_square = (x * x + y * y) / 2, value = curvature * half_square - y;
  // `ratio` is the distance of the point from the centre, divided by the radius.
  const double ratio = std::sqrt(1 + 2 * curvature * value);
  derivative << -curvature * x / ratio,
    half_square / ratio - 2 * value * value / (ratio * (1 + ratio) * (1 + ratio)),
    (1 - curvature * y) / ratio;
  return 2 * value / (1 + ratio); // free of cancellation for large radii
}

} // namespace

std::optional<RimCircle> fit_rim_circle(const std::vector<SectionVertex> &polyline, double land_width)
{
  if (polyline.empty())
    return {};
  const auto is_lower = [](const auto &a, const auto &b) { return a.height < b.height; };
  const auto lowest = std::min_element(polyline.begin(), polyline.end(), is_lower);
  const double scale = land_width / 2;
  const std::vector<Vector2d> points = points_near(lowest, polyline, scale);
  double moment = 0, square = 0;
  for (const Vector2d &point : points)
    if (const double x = point.x(); std::abs(x) <= 1)
      moment += x * x * point.y(), square += x * x * x * x;
  Vector3d circle(0, 2 * moment / square, 0); // initial guess: a parabola through the lowest point
  // With the curvature `flat`, the rim rises by 1/1000 of the land width over half the land.
  constexpr double max_steps = 200, flat = 4e-3;
  for (unsigned int i = 1; circle(1) > 0 && std::abs(circle(0)) <= 1; ++i)
  {
    Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
    Vector3d right = Vector3d::Zero(), derivative;
    double sum_of_weights = 0, sum_of_squares = 0;
    std::size_t n_points = 0;
    for (const Vector2d &point : points)
      if (const double weight = weight_at(point.x() - circle(0)); weight > 0)
      {
        const double distance = distance_from(circle, point, derivative);
        matrix += weight * derivative * derivative.transpose();
        right += weight * distance * derivative;
        sum_of_weights += weight, sum_of_squares += weight * distance * distance, ++n_points;
      }
    // A step moves the circle's lowest point and thus changes the weights. Full steps could oscillate.
    const Vector3d step = 0.7 * matrix.fullPivLu().solve(right);
    if (n_points < 3)
      break;
    if (i == max_steps || step.lpNorm<Eigen::Infinity>() < 1e-14 * std::max(1., circle(1)))
      return circle(1) < flat
               ? std::nullopt
               : std::optional(RimCircle{ lowest->radius + scale * circle(0), scale / circle(1),
                                          scale * std::sqrt(sum_of_squares / sum_of_weights), n_points });
    circle -= step;
  }
  return {};
}

} // namespace stemware::fem
