#include "fem/contact/sliding_traction.h"

#include "fem/geometry/require.h"

#include <cmath>

namespace stemware::fem
{

Eigen::Vector2d coulomb_friction(const Eigen::Vector2d &slip, double limit)
{
  const double speed = slip.norm();
  if (speed == 0)
    return Eigen::Vector2d::Zero();
  return -limit / speed * slip;
}

Eigen::Vector2d SlidingTraction::direction(double radius, double azimuth) const
{
  // v_rel / v = e_x + (omega / v) r e_theta, in radial and azimuthal components.
  const double theta = azimuth + axes_rotation;
  const Eigen::Vector2d slip(std::cos(theta), -std::sin(theta) + spin_per_speed * radius);
  return coulomb_friction(slip,
                          coefficient_by_slip ? coefficient_by_slip(slip.norm()) : friction_coefficient);
}

void SlidingTraction::validate() const
{
  require(std::isfinite(friction_coefficient) && friction_coefficient >= 0,
          "Friction coefficient = ", friction_coefficient,
          " is not allowed; give a finite number of at least 0.");
  require(std::isfinite(spin_per_speed), "The yaw rate per speed, ", spin_per_speed,
          " 1/m, must be finite: friction of a foot that only spins has no direction of travel.");
}

} // namespace stemware::fem
