#include "fem/contact/contact_surface.h"

#include <boost/math/constants/constants.hpp>

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
  std::vector<double> azimuths;
  for (unsigned int i = 0; i < n_nodes(); ++i)
    if (pressure(i) > 0)
      azimuths.push_back(std::atan2(node_position(i, 1), node_position(i, 0)));
  std::sort(azimuths.begin(), azimuths.end());

  const double side_by_side = boost::math::double_constants::two_pi / (8 * n_sectors);
  std::ptrdiff_t most = 0;
  auto end = azimuths.begin();
  for (auto begin = azimuths.begin(); begin != azimuths.end(); ++begin)
  {
    while (end != azimuths.end() && *end - *begin < side_by_side)
      ++end;
    most = std::max(most, end - begin);
  }
  return static_cast<unsigned int>(most);
}

std::vector<PointForce> turned_by(std::vector<PointForce> forces, double angle)
{
  const double cosine = std::cos(angle), sine = std::sin(angle);
  for (PointForce &point : forces)
    point = { cosine * point.x - sine * point.y, sine * point.x + cosine * point.y, point.force };
  return forces;
}

} // namespace stemware::fem
