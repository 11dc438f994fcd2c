#pragma once

// Rigid foot, crowned or flat, possibly wavy, on a compliant interface, by plain sums over points of its
// land. It shares no code with the program and uses no rings, harmonics or kernels.
#include "ring_model/load/constants.h"

#include <Eigen/Dense>
#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <vector>

namespace stemware::verification
{

struct PlainPoint
{
  double x, y, force; ///< [m], [N]
};

/// Returns the zero of @p residual(position) by damped Newton's method with difference quotients in units of
/// @p scale. Throws std::runtime_error if the iteration does not converge.
template <typename Residual>
Eigen::Vector3d find_position(const Residual &residual, Eigen::Vector3d position,
                              const Eigen::Vector3d &scale)
{
  for (unsigned int step = 0; step < 60; ++step)
  {
    const Eigen::Vector3d now = residual(position);
    Eigen::Matrix3d slope;
    for (int k = 0; k < 3; ++k)
    {
      Eigen::Vector3d there = position;
      there(k) += 1e-6 * scale(k);
      slope.col(k) = (residual(there) - now) / 1e-6;
    }
    const Eigen::Vector3d change = -slope.partialPivLu().solve(now);
    double length = 1;
    while (length > 1e-3 && now.norm() > 1e-10 &&
           !(residual(position + length * scale.cwiseProduct(change)).norm() < now.norm()))
      length /= 2;
    position += length * scale.cwiseProduct(change);
    if (change.norm() < 1e-10)
      return position;
  }
  throw std::runtime_error("Newton's method of the plain foot did not converge");
}

/// Penetration d(r, theta) = d0 + d1 x + d2 y - (r - R)^2 / (2 crown) - wave(theta) on r_inner < r < r_outer.
struct PlainRigidFoot
{
  double contact_radius = 0.030, inner_radius = 0.028, outer_radius = 0.032;
  double crown_radius = 0.003; ///< 0: flat
  std::function<double(double)> wave = [](double) { return 0.; };
  std::function<double(double)> pressure; ///< as a function of the penetration [Pa]
  bool pulls_apart = true;                ///< true: no pressure at negative penetration
  unsigned int n_azimuths = 720;
  unsigned int n_pieces = 1; ///< number of pieces of each ray, for a pressure that is not a polynomial

  static PlainRigidFoot on_mat(double modulus)
  {
    PlainRigidFoot foot;
    foot.pressure = [modulus](double depth) { return modulus * depth; };
    return foot;
  }

  std::vector<PlainPoint> forces(const Eigen::Vector3d &position) const
  {
    using Gauss = boost::math::quadrature::gauss<double, 10>;
    std::vector<PlainPoint> points;
    for (unsigned int j = 0; j < n_azimuths; ++j)
    {
      const double theta = 2 * ring::pi * j / n_azimuths, c = std::cos(theta), s = std::sin(theta);
      const double slope = position(1) * c + position(2) * s, lift = wave(theta);
      const auto depth = [&](double r)
      {
        const double off = r - contact_radius;
        return position(0) + slope * r - lift - (crown_radius > 0 ? off * off / (2 * crown_radius) : 0);
      };
      double from = inner_radius, to = outer_radius;
      if (pulls_apart && crown_radius > 0)
      {
        const double top = contact_radius + crown_radius * slope, deepest = depth(top);
        const double half_width = std::sqrt(2 * crown_radius * std::max(deepest, 0.));
        from = std::max(from, top - half_width);
        to = std::min(to, top + half_width);
      }
      else if (pulls_apart && depth(from) * depth(to) < 0)
        (depth(from) < 0 ? from : to) = (lift - position(0)) / slope;
      if (!(to > from) || (pulls_apart && !(depth((from + to) / 2) > 0)))
        continue;
      const double piece = (to - from) / n_pieces;
      for (unsigned int k = 0; k < n_pieces; ++k)
        for (std::size_t i = 0; i < Gauss::abscissa().size(); ++i)
          for (const double side : { -1., 1. })
          {
            const double r = from + piece * (k + (1 + side * Gauss::abscissa()[i]) / 2);
            const double area = piece / 2 * Gauss::weights()[i] * r * 2 * ring::pi / n_azimuths;
            points.push_back({ r * c, r * s, pressure(depth(r)) * area });
          }
    }
    return points;
  }

  /// Returns the position under a normal force and a moment (sum y f, -sum x f), from the initial penetration
  /// @p depth.
  Eigen::Vector3d position_under(double force, double moment_x, double moment_y, double depth) const
  {
    const auto residual = [&](const Eigen::Vector3d &position)
    {
      Eigen::Vector3d sum(-force, -moment_x / contact_radius, -moment_y / contact_radius);
      for (const PlainPoint &point : forces(position))
        sum += point.force * Eigen::Vector3d(1, point.y / contact_radius, -point.x / contact_radius);
      return Eigen::Vector3d(sum / force);
    };
    const double tilt = depth / contact_radius;
    Eigen::Vector3d position(depth, 0, 0);
    const double full_x = moment_x, full_y = moment_y;
    for (unsigned int part = 0; part <= 8; ++part)
    {
      moment_x = full_x * part / 8;
      moment_y = full_y * part / 8;
      position = find_position(residual, position, { depth, tilt, tilt });
    }
    return position;
  }
};

/// Returns a_n / a_0 or, for @p sine, b_n / a_0 of point forces.
inline double harmonic_over_mean(const std::vector<PlainPoint> &points, unsigned int n, bool sine = false)
{
  double sum = 0, force = 0;
  for (const PlainPoint &point : points)
  {
    const double angle = n * std::atan2(point.y, point.x);
    sum += 2 * point.force * (sine ? std::sin(angle) : std::cos(angle));
    force += point.force;
  }
  return sum / force;
}

struct PlainMotion
{
  double mass, inertia, centre_of_mass_height, force_offset, orbit_radius, speed, friction, gravity;
};

/// Moments of all forces on a glass about its centre of mass, in three dimensions. The axis leans with the
/// foot. The force of the hand, m a - T, acts on the axis at force_offset above the centre of mass.
struct PlainGlass
{
  PlainGlass(const std::vector<PlainPoint> &points, const Eigen::Vector3d &position, double omega,
             const PlainMotion &motion)
  {
    const Eigen::Vector3d axis(position(1), position(2), 1);
    const Eigen::Vector3d centre = motion.centre_of_mass_height * axis;
    for (const PlainPoint &point : points)
    {
      const Eigen::Vector3d slip(motion.speed - omega * point.y, omega * point.x, 0);
      const Eigen::Vector3d tangential = -motion.friction * point.force * slip.normalized();
      const Eigen::Vector3d normal(0, 0, point.force), place(point.x, point.y, 0);
      friction += tangential;
      contact_moment += place.cross(normal);
      friction_torque += place.cross(tangential).z();
      moment += (place - centre).cross(normal + tangential);
    }
    const Eigen::Vector3d pull =
      Eigen::Vector3d(0, motion.mass * motion.speed * motion.speed / motion.orbit_radius, 0) - friction;
    moment += motion.force_offset * axis.cross(pull);
    axial_torque = moment.dot(axis); // the length of `axis` differs from one by 1e-9
  }

  Eigen::Vector3d friction = Eigen::Vector3d::Zero();
  /// Moment of the normal forces about the ring's centre.
  Eigen::Vector3d contact_moment = Eigen::Vector3d::Zero();
  double friction_torque = 0;                       ///< about the vertical through the ring's centre
  Eigen::Vector3d moment = Eigen::Vector3d::Zero(); ///< of all forces, about the centre of mass
  double axial_torque = 0;                          ///< about the leaning axis
};

/// Returns the position at which the vertical force and the horizontal moments vanish at the spin @p omega.
inline Eigen::Vector3d position_in_balance(const PlainRigidFoot &foot, const PlainMotion &motion,
                                           double omega, const Eigen::Vector3d &start, double depth)
{
  const double weight = motion.mass * motion.gravity, tilt = depth / foot.contact_radius;
  const auto residual = [&](const Eigen::Vector3d &position)
  {
    const std::vector<PlainPoint> points = foot.forces(position);
    double force = -weight;
    for (const PlainPoint &point : points)
      force += point.force;
    const PlainGlass glass(points, position, omega, motion);
    return Eigen::Vector3d(force / weight, glass.moment.x() / (weight * foot.contact_radius),
                           glass.moment.y() / (weight * foot.contact_radius));
  };
  return find_position(residual, start, { depth, tilt, tilt });
}

} // namespace stemware::verification
