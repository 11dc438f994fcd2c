#include "fem/contact/contact_demand.h"

#include "fem/contact/contact_load.h"

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace stemware::fem
{

namespace
{

/// Value of a load function under a unit force at azimuth theta, for each ring that may carry the force.
/// Nodes that follow each other on one azimuth share one evaluation.
class RingValues
{
public:
  explicit RingValues(const ring::LoadFunctional &function)
      : function(function)
      , values(static_cast<Eigen::Index>(function.a.size()))
  {
  }

  const Eigen::VectorXd &at(double cosine, double sine)
  {
    if (std::abs(cosine - last_cosine) + std::abs(sine - last_sine) < 1e-14)
      return values;
    last_cosine = cosine;
    last_sine = sine;
    for (std::size_t j = 0; j < function.a.size(); ++j)
    {
      double even = 1, odd = 0, sum = function.a[j][0] / 2;
      for (std::size_t n = 1; n < function.a[j].size(); ++n)
      {
        const double next = even * cosine - odd * sine;
        odd = even * sine + odd * cosine;
        even = next;
        sum += function.a[j][n] * even + function.b[j][n] * odd;
      }
      values(static_cast<Eigen::Index>(j)) = sum / boost::math::double_constants::pi;
    }
    return values;
  }

private:
  const ring::LoadFunctional &function;
  Eigen::VectorXd values;
  double last_cosine = 2;
  double last_sine = 2;
};

} // namespace

ContactDemand ContactDemand::in_axes_turned_by(double angle) const
{
  const double cosine = std::cos(angle), sine = std::sin(angle);
  ContactDemand demand = *this;
  demand.moment_x = cosine * moment_x + sine * moment_y;
  demand.moment_y = cosine * moment_y - sine * moment_x;
  if (has_friction())
  {
    demand.friction_x = (cosine * friction_x + sine * friction_y).of_rotated(angle);
    demand.friction_y = (cosine * friction_y + -sine * friction_x).of_rotated(angle);
  }
  return demand;
}

Eigen::VectorXd node_values(const ContactSurface &surface, const std::vector<double> &ring_radii,
                            const ring::LoadFunctional &function)
{
  const RingShares shares(ring_radii);
  RingValues values(function);
  Eigen::VectorXd result(surface.n_nodes());
  // Radial lines repeat their radii: the shares of one do for all.
  const unsigned int n_repeated =
    surface.lines_are_radial ? surface.n_nodes() / std::max(surface.n_sectors, 1u) : 0;
  std::vector<std::pair<double, Eigen::VectorXd>> on_line(n_repeated);
  for (unsigned int i = 0; i < surface.n_nodes(); ++i)
  {
    const double x = surface.node_position(i, 0), y = surface.node_position(i, 1);
    const double radius = std::hypot(x, y);
    const Eigen::VectorXd &of_rings = values.at(radius > 0 ? x / radius : 1, radius > 0 ? y / radius : 0);
    if (n_repeated == 0)
    {
      result(i) = shares.at(radius).dot(of_rings);
      continue;
    }
    auto &[known_radius, known_shares] = on_line[i % n_repeated];
    if (std::abs(radius - known_radius) > 1e-14 * radius)
    {
      known_radius = radius;
      known_shares = shares.at(radius);
    }
    result(i) = known_shares.dot(of_rings);
  }
  return result;
}

LinearConditions conditions_of(const ContactSurface &surface, const ContactDemand &demand)
{
  if (!demand.has_friction() && demand.tilt_moment == 0)
    return prescribed_resultants(surface, demand);
  Eigen::MatrixX3d weights = surface.motion_modes();
  if (demand.has_friction())
  {
    weights.col(1) += node_values(surface, demand.ring_radii, demand.friction_y);
    weights.col(2) -= node_values(surface, demand.ring_radii, demand.friction_x);
  }
  const Eigen::Matrix3d leaning = Eigen::Vector3d(0, demand.tilt_moment, demand.tilt_moment).asDiagonal();
  return { surface, std::move(weights), { demand.normal_force, -demand.moment_y, demand.moment_x }, leaning };
}

} // namespace stemware::fem
