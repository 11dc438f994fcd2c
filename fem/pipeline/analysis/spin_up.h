#pragma once

#include "ring_model/yaw_motion.h"

#include <Eigen/Core>
#include <boost/math/interpolators/cardinal_cubic_b_spline.hpp>

#include <functional>
#include <vector>

namespace stemware::pipeline
{

/// Yaw torque between rest and a spin: the polynomial through its values at Chebyshev points.
class TorqueBySpin
{
public:
  static constexpr Eigen::Index n_points = 49;
  /// Returns the points as shares of the last spin, from 0 to 1. Shape [n_points].
  static const Eigen::VectorXd &shares();

  /// @p values: torques [N m] at shares() of the spin @p last [rad/s], which is not 0.
  TorqueBySpin(double last, const Eigen::VectorXd &values);

  double last_spin() const { return last; }
  /// Returns the torque [N m] at @p omega [rad/s]; beyond rest and the last spin that of the nearer one.
  double operator()(double omega) const;
  /// Returns the derivative of the torque by the spin [N m s].
  double slope(double omega) const;

private:
  double last;
  Eigen::VectorXd coefficients, of_slope; ///< of Chebyshev polynomials
};

/// Spin and yaw angle over the time, or their derivatives by an entry; 0 before the start, and a constant
/// spin after the last sample.
class SpinCourse
{
public:
  /// @p spins [rad/s] and @p angles [rad] at multiples of @p step [s], from 0 on.
  SpinCourse(const std::vector<double> &spins, const std::vector<double> &angles, double step);

  double spin(double time) const { return time <= 0 ? 0 : time >= end ? last_spin : of_spin(time); }
  double acceleration(double time) const { return time <= 0 || time >= end ? 0 : of_spin.prime(time); }
  double yaw_angle(double time) const
  {
    return time <= 0 ? 0 : time >= end ? last_angle + (time - end) * last_spin : of_angle(time);
  }

private:
  double end, last_spin, last_angle;
  boost::math::interpolators::cardinal_cubic_b_spline<double> of_spin, of_angle;
};

/// Torque on a glass that begins at rest.
struct SpinUpTorque
{
  TorqueBySpin free;  ///< without the grip
  double grip;        ///< of the fingers, against the spin [N m]
  double yaw_inertia; ///< [kg m^2]

  /// Returns the torque with the grip [N m] at the spin @p omega [rad/s].
  double operator()(double omega) const;
};

/// Spin-up from rest under a torque that depends on the spin only.
class SpinUp : public SpinCourse
{
public:
  static constexpr int n_steps = 1200; ///< samples after the first

  /// @p spin_scale: v / R [rad/s]; @p step: of the samples [s].
  SpinUp(const SpinUpTorque &torque, double spin_scale, double step);

  /// Returns the derivatives of spin and yaw angle by an entry, of which @p torque_change(spin) is the
  /// derivative of the torque at a given spin: the solution of the linearised equation of motion, by
  /// fourth-order Runge-Kutta steps between the samples.
  SpinCourse derivative(const std::function<double(double omega)> &torque_change) const;

  const SpinUpTorque &torque() const { return given; }
  double last_spin() const { return spin(step * n_steps); }

private:
  SpinUp(const SpinUpTorque &torque, const std::vector<ring::YawSample> &samples, double step);

  SpinUpTorque given;
  double step;
};

} // namespace stemware::pipeline
