#include "fem/contact/contact_surface.h"

#include "ring_model/load/constants.h"

#include <algorithm>
#include <cmath>

namespace stemware::fem
{

Eigen::MatrixX3d ContactSurface::motion_modes() const
{
  Eigen::MatrixX3d modes(n_nodes(), 3);
  modes.col(0).setOnes();
  modes.rightCols<2>() = node_position;
  return modes;
}

unsigned int ContactSurface::n_nodes_across(const Eigen::VectorXd &pressure) const
{
  // A radial row is a window of 8 adjacent bins, an eighth of a sector. Rounding errors of the azimuth move a
  // node by at most one bin, so one of the windows contains all nodes of equal azimuth.
  constexpr std::size_t n_bins_side_by_side = 8;
  const std::size_t n_bins = 8 * n_bins_side_by_side * n_sectors;
  std::vector<double> n_loaded(n_bins, 0);
  Eigen::RowVector2d before(0, 0); // last binned node; the next nodes of its line reuse `bin` without atan2()
  std::size_t bin = 0;
  for (unsigned int i = 0; i < n_owned_nodes(); ++i)
    if (pressure(i) > 0)
    {
      const Eigen::RowVector2d node = node_position.row(i);
      const double along = node.dot(before), across = node(1) * before(0) - node(0) * before(1);
      if (!(std::abs(across) < 1e-14 * along))
      {
        const double turns = std::atan2(node(1), node(0)) / (2 * ring::pi);
        bin = static_cast<std::size_t>((turns - std::floor(turns)) * double(n_bins)) % n_bins;
        before = node;
      }
      ++n_loaded[bin];
    }
  parts.sum_in_place(n_loaded);
  double max_side_by_side = 0;
  for (std::size_t first = 0; first < n_bins; ++first)
  {
    double n_side_by_side = 0;
    for (std::size_t i = 0; i < n_bins_side_by_side; ++i)
      n_side_by_side += n_loaded[(first + i) % n_bins];
    max_side_by_side = std::max(max_side_by_side, n_side_by_side);
  }
  return static_cast<unsigned int>(max_side_by_side);
}

std::vector<PointForce> rotated_by(std::vector<PointForce> forces, double angle)
{
  const double cosine = std::cos(angle), sine = std::sin(angle);
  for (PointForce &point : forces)
    point = { cosine * point.x - sine * point.y, sine * point.x + cosine * point.y, point.force };
  return forces;
}

} // namespace stemware::fem
