#pragma once

#include "ring_model/moment_balance.h"

#include <boost/math/constants/constants.hpp>
#include <boost/math/tools/roots.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace stemware::pipeline
{

/// How the line load of a rigid ring follows the penetration d: stiffness d^exponent [N/m], which only
/// pushes, or exp(d / decay_length). An infinite stiffness is a support that yields nothing.
struct LineLaw
{
  double exponent = 1.5;
  double stiffness = INFINITY; ///< [N / m^(1 + exponent)]
  double decay_length = 0;     ///< of an exponential law [m]; 0: none
};

/// A rigid ring on a yielding table that only pushes, in balance with its friction, the hand and its own
/// weight as it leans: a check of what tips that shares nothing with finite elements and Newton's method.
///
/// The loads lambda(theta; u, beta) of such a ring are known but for their concentration u, 0 < u < 1, and
/// the direction beta of their maximum. Each of them is in balance at some acceleration of the glass; the
/// ring tips where the largest of these is less than that of the orbit.
class LeaningRigidRing
{
public:
  LeaningRigidRing(const LineLaw &law, double radius, ring::Closure closure, const ring::Motion &motion,
                   bool tilts)
      : law(law)
      , radius(radius)
      , motion(motion)
      , arm(ring::friction_arm(closure, motion))
      , applied(ring::required_moment(closure, motion, Eigen::Vector2d::Zero()))
      , lean_moment(tilts ? motion.normal_force() * motion.centre_of_mass_height : 0)
  {
  }

  /// The slip ratio omega R / v from rest towards the terminal spin at which the ring no longer balances;
  /// nothing where it does all the way.
  std::optional<double> tips_at() const
  {
    double direction = 0;
    for (double slip = 0; slip < 3; slip += 1. / 32)
    {
      const std::optional<double> torque = torque_in_balance(direction * slip);
      if (!torque)
        return direction * slip;
      if (direction == 0)
        direction = *torque < 0 ? -1 : 1;
      if (*torque * direction <= 0)
        return {};
    }
    return {};
  }

private:
  static constexpr unsigned int n_points = 720;

  struct Load
  {
    double direction;
    std::vector<double> forces; ///< at equally spaced azimuths from `direction` on [N]
    double lean;                ///< of the glass towards `direction` [rad]
  };

  Load load(double concentration, double direction) const
  {
    const double edge = 1 - 2 * (1 - concentration) / concentration;
    const double bell = concentration / (1 - concentration);
    Load result = { direction, std::vector<double>(n_points), 0 };
    double sum = 0;
    for (unsigned int i = 0; i < n_points; ++i)
    {
      const double cosine = std::cos(azimuth(i));
      result.forces[i] = law.decay_length > 0 ? std::exp(bell * (cosine - 1))
                                              : std::pow(std::max(0., cosine - edge), law.exponent);
      sum += result.forces[i];
    }
    for (double &force : result.forces)
      force *= motion.normal_force() / sum;
    const double step = boost::math::double_constants::two_pi * radius / n_points;
    const double depth = law.decay_length > 0
                           ? bell * law.decay_length
                           : std::pow(motion.normal_force() / (law.stiffness * step * sum), 1 / law.exponent);
    result.lean = depth / radius;
    return result;
  }

  static double azimuth(unsigned int i)
  {
    return boost::math::double_constants::two_pi * (i + 0.5) / n_points;
  }

  /// Friction force and torque, and the moment of the acceleration that is in balance with the load.
  struct Balance
  {
    Eigen::Vector2d acceleration_moment;
    double torque;
  };

  Balance balance(const Load &pressed, double slip) const
  {
    Eigen::Vector2d friction(0, 0), moment(0, 0);
    double torque = 0;
    for (unsigned int i = 0; i < n_points; ++i)
    {
      const double theta = pressed.direction + azimuth(i);
      const Eigen::Vector2d place(radius * std::cos(theta), radius * std::sin(theta));
      const Eigen::Vector2d velocity(1 - slip * std::sin(theta), slip * std::cos(theta));
      const double speed = velocity.norm();
      const Eigen::Vector2d force =
        speed > 0 ? Eigen::Vector2d(-motion.friction_coefficient * pressed.forces[i] / speed * velocity)
                  : Eigen::Vector2d(0, 0);
      friction += force;
      torque += place.x() * force.y() - place.y() * force.x();
      moment += pressed.forces[i] * Eigen::Vector2d(place.y(), -place.x());
    }
    const Eigen::Vector2d of_lean =
      lean_moment * pressed.lean * Eigen::Vector2d(std::sin(pressed.direction), -std::cos(pressed.direction));
    return { moment - of_lean - arm * Eigen::Vector2d(-friction.y(), friction.x()), torque };
  }

  /// The torque of the least concentrated load in balance with the orbit; nothing where there is none.
  std::optional<double> torque_in_balance(double slip) const
  {
    if (applied.norm() == 0)
      return 0;
    const Eigen::Vector2d along = applied.normalized();
    const double towards = std::atan2(along.x(), -along.y()); // of the maximum of a load with that moment
    for (double concentration = 0.02; concentration < 0.999; concentration += 0.01)
    {
      const auto across = [&](double angle)
      {
        const Eigen::Vector2d moment =
          balance(load(concentration, towards + angle), slip).acceleration_moment;
        return along.x() * moment.y() - along.y() * moment.x();
      };
      constexpr double right_angle = boost::math::double_constants::half_pi;
      const double first = across(-right_angle), last = across(right_angle);
      if (first * last >= 0)
        continue;
      boost::uintmax_t n_steps = 60;
      const auto bracket =
        boost::math::tools::toms748_solve(across, -right_angle, right_angle, first, last,
                                          boost::math::tools::eps_tolerance<double>(30), n_steps);
      const Balance found = balance(load(concentration, towards + bracket.first), slip);
      if (found.acceleration_moment.dot(along) >= applied.norm())
        return found.torque;
    }
    return {};
  }

  const LineLaw law;
  const double radius;
  const ring::Motion motion;
  const double arm;
  const Eigen::Vector2d applied;
  const double lean_moment;
};

} // namespace stemware::pipeline
