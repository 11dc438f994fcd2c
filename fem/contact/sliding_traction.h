#pragma once

#include <Eigen/Core>

#include <functional>

namespace stemware::fem
{

/// Returns the Coulomb friction of size @p limit against the velocity @p slip of any unit; zero without slip.
Eigen::Vector2d coulomb_friction(const Eigen::Vector2d &slip, double limit);

/// Friction on a foot that slides along x and yaws: a tangential traction of mu times the pressure, against
/// the slip v_rel = (v - omega y, omega x) of the foot over the table.
struct SlidingTraction
{
  double friction_coefficient = 0; ///< mu, >= 0
  /// omega / v [1/m], counter-clockwise > 0; 0: at rest in yaw. eps = spin_per_speed * R.
  double spin_per_speed = 0;
  double axes_rotation = 0; ///< zero of azimuths, counter-clockwise from travel [rad]
  /// mu as a function of |v_rel| / v. Empty: friction_coefficient everywhere.
  std::function<double(double relative_slip)> coefficient_by_slip = {};

  /// Returns the radial and azimuthal traction on the foot over the pressure at (r, theta): (-mu cos theta,
  /// mu sin theta) at omega = 0; zero without slip.
  Eigen::Vector2d direction(double radius, double azimuth) const;

  /// Throws std::invalid_argument unless mu and spin are finite and mu >= 0.
  void validate() const;
};

} // namespace stemware::fem
