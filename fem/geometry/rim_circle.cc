#include "fem/geometry/meridian_section.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace stemware::fem
{

std::optional<RimCircle> fit_rim_circle(const std::vector<SectionVertex> &polyline, double land_width)
{
  if (polyline.empty())
    return {};
  const SectionVertex lowest =
    *std::min_element(polyline.begin(), polyline.end(),
                      [](const SectionVertex &a, const SectionVertex &b) { return a.height < b.height; });
  // In halves of the land from the lowest point, so that the columns are of one size.
  const double scale = land_width / 2;
  std::vector<Eigen::Vector2d> points;
  double bulge = 0, least = 0, most = 0;
  for (const SectionVertex &vertex : polyline)
  {
    const Eigen::Vector2d point =
      Eigen::Vector2d(vertex.radius - lowest.radius, vertex.height - lowest.height) / scale;
    if (point.cwiseAbs().maxCoeff() > 1)
      continue;
    points.push_back(point);
    bulge = std::max(bulge, point.y());
    least = std::min(least, point.x());
    most = std::max(most, point.x());
  }
  if (points.size() < 3 || bulge < 1e-3 * (most - least))
    return {};
  Eigen::MatrixX3d matrix(points.size(), 3);
  Eigen::VectorXd right(points.size());
  for (Eigen::Index i = 0; i < right.size(); ++i)
  {
    const Eigen::Vector2d &point = points[static_cast<std::size_t>(i)];
    matrix.row(i) << 2 * point.x(), 2 * point.y(), 1;
    right(i) = point.squaredNorm();
  }
  const Eigen::Vector3d fit = matrix.colPivHouseholderQr().solve(right);
  const double radius_squared = fit(2) + fit.head<2>().squaredNorm();
  if (!(fit(1) > 0) || !(radius_squared > 0) || !fit.allFinite())
    return {};
  return RimCircle{ lowest.radius + scale * fit(0), scale * std::sqrt(radius_squared),
                    static_cast<unsigned int>(points.size()) };
}

} // namespace stemware::fem
