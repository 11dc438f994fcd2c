#include "fem/contact/contact_demand.h"

#include "fem/contact/contact_load.h"
#include "ring_model/load/constants.h"

#include <cmath>
#include <utility>
#include <vector>

namespace stemware::fem
{

namespace
{

/// Returns one value per ring: @p function of a unit force on this ring. The force acts at the azimuth that
/// is given by its @p cosine and @p sine.
Eigen::VectorXd ring_values(const ring::LoadFunctional &function, double cosine, double sine)
{
  Eigen::ArrayXd sum = function.a.row(0).transpose() / 2;
  double even = 1, odd = 0;
  for (Eigen::Index n = 1; n < function.a.rows(); ++n)
  {
    const double next = even * cosine - odd * sine;
    odd = even * sine + odd * cosine;
    even = next;
    sum += (function.a.row(n) * even + function.b.row(n) * odd).transpose();
  }
  return sum / ring::pi;
}

} // namespace

ContactDemand ContactDemand::in_rotated_axes(double angle) const
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
  const RingWeights shares(ring_radii);
  Eigen::VectorXd result(surface.n_nodes());
  double cosine = 1, sine = 0;
  Eigen::VectorXd of_rings = ring_values(function, cosine, sine);
  for (unsigned int i = 0; i < surface.n_nodes(); ++i)
  {
    const double x = surface.node_position(i, 0), y = surface.node_position(i, 1);
    double radius = x * cosine + y * sine;
    if (!(std::abs(y * cosine - x * sine) <= 1e-14 * radius))
    {
      radius = std::hypot(x, y);
      cosine = x / radius;
      sine = y / radius;
      of_rings = ring_values(function, cosine, sine);
    }
    result(i) = shares.at(radius).dot(of_rings);
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
