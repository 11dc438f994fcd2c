#pragma once

// Rigid crowned foot on a Winkler mat with lift-off, by plain quadrature up to the contact edges. It shares
// no code with the program and uses no rings, harmonics or kernels.
#include "ring_model/load/constants.h"
#include "tests/verification/plain_rigid_foot.h"

#include <Eigen/Dense>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace stemware::verification
{

/// Default glass with a rigid foot and Coulomb friction on a counter-clockwise orbit at constant speed; SI
/// units.
struct LiftedFoot
{
  double contact_radius = 0.030, crown_radius = 0.003, foundation_modulus = 1e10;
  double mass = 0.3, inertia = 3e-4, gravity = 9.81, friction = 0.3, speed = 0.35, orbit_radius = 0.15;
  double force_offset = -0.05, centre_of_mass_height = 0.08;
  bool tilts = true;

  double weight() const { return mass * gravity; }

  /// Penetration d0 + d1 x + d2 y - (r - R)^2 / (2 crown) [m] of a foot at @p position = (d0 [m], d1, d2
  /// [rad]), in polar coordinates.
  class Contact
  {
  public:
    Contact(const LiftedFoot &foot, const Eigen::Vector3d &position)
        : foot(foot)
        , position(position)
        , lean(std::hypot(position(1), position(2)))
        , direction(std::atan2(position(2), position(1)))
    {
    }

    /// Returns the largest penetration [m] along the ray at the angle @p phi from the direction of the lean.
    double deepest(double phi) const
    {
      const double slope = lean * std::cos(phi);
      return position(0) + slope * foot.contact_radius + foot.crown_radius * slope * slope / 2;
    }

    /// Returns the angle from the direction of the lean to the contact edge [rad]; pi without lift-off.
    double edge() const
    {
      const double R = foot.contact_radius, crown = foot.crown_radius;
      const double cosine = (std::sqrt(R * R - 2 * crown * position(0)) - R) / (crown * lean);
      return cosine <= -1 || !(lean > 0) ? ring::pi : std::acos(std::min(1., cosine));
    }

    double azimuth_share() const { return edge() / ring::pi; }
    double largest_pressure() const { return foot.foundation_modulus * deepest(0); }

    /// Returns the line load at @p phi [N/rad], the closed form for a parabolic pressure across the rim.
    double line_load(double phi) const
    {
      const double top = std::max(0., deepest(phi)), half_width = std::sqrt(2 * foot.crown_radius * top);
      return foot.foundation_modulus * 4 / 3 * top * half_width *
             (foot.contact_radius + foot.crown_radius * lean * std::cos(phi));
    }

    /// Calls visit(phi, weight [rad]) at Gauss points of panels that end at the contact edges and at @p
    /// split, or at equidistant angles without lift-off.
    template <typename Visitor>
    void for_each_azimuth(double split, const Visitor &visit) const
    {
      const double end = edge();
      if (end == ring::pi)
        for (unsigned int i = 0; i < n_azimuths; ++i)
          visit(split + 2 * ring::pi * (i + 0.5) / n_azimuths, 2 * ring::pi / n_azimuths);
      else
      {
        const double between = std::abs(split) < end ? split : 0;
        for_graded(-end, between, visit);
        for_graded(between, end, visit);
      }
    }

    /// Calls visit(x, y, force) at quadrature points. The panels end at the point without slip at @p omega.
    template <typename Visitor>
    void for_each_force(double omega, const Visitor &visit) const
    {
      const double still_radius = foot.speed / std::abs(omega);
      const double still = std::remainder((omega < 0 ? -ring::pi : ring::pi) / 2 - direction, 2 * ring::pi);
      for_each_azimuth(still,
                       [&](double phi, double arc)
                       {
                         const double slope = lean * std::cos(phi), theta = direction + phi;
                         const double top = foot.contact_radius + foot.crown_radius * slope;
                         const double half = std::sqrt(2 * foot.crown_radius * std::max(0., deepest(phi)));
                         const auto at = [&](double r, double width)
                         {
                           const double off = r - foot.contact_radius;
                           const double depth = position(0) + slope * r - off * off / (2 * foot.crown_radius);
                           visit(r * std::cos(theta), r * std::sin(theta),
                                 foot.foundation_modulus * depth * r * width * arc);
                         };
                         const bool is_split = std::abs(still_radius - top) < half;
                         const double between = is_split ? still_radius : top;
                         for_graded(top - half, between, at);
                         for_graded(between, top + half, at);
                       });
    }

    double harmonic(unsigned int n, bool sine) const
    {
      double sum = 0, force = 0;
      for_each_azimuth(0,
                       [&](double phi, double arc)
                       {
                         const double load = arc * line_load(phi), angle = n * (direction + phi);
                         force += load;
                         sum += 2 * load * (sine ? std::sin(angle) : std::cos(angle));
                       });
      return sum / force;
    }

    /// Calls visit(x, y, force) for the first harmonic of the pressure at every radius, from closed forms of
    /// the azimuthal integrals.
    template <typename Visitor>
    void for_each_force_of_first_harmonic(const Visitor &visit) const
    {
      const double R = foot.contact_radius, crown = foot.crown_radius;
      const auto radii = [&](double slope) // radii at which the penetration vanishes for @p slope
      {
        const double top = R + crown * slope;
        const double half =
          std::sqrt(std::max(0., 2 * crown * (position(0) + slope * R + crown * slope * slope / 2)));
        return std::make_pair(top - half, top + half);
      };
      const auto whole = radii(lean), all_round = radii(-lean);
      const auto at = [&](double r, double width)
      {
        const double mean = position(0) - (r - R) * (r - R) / (2 * crown), swing = lean * r;
        const double end = mean >= swing ? ring::pi : std::acos(std::clamp(-mean / swing, -1., 1.));
        const double per_radian = foot.foundation_modulus * r * width;
        const double a0 = per_radian / ring::pi * (mean * end + swing * std::sin(end));
        const double a1 =
          per_radian * 2 / ring::pi * (mean * std::sin(end) + swing * (end / 2 + std::sin(2 * end) / 4));
        for (unsigned int i = 0; i < n_azimuths; ++i)
        {
          const double phi = 2 * ring::pi * i / n_azimuths, theta = direction + phi;
          visit(r * std::cos(theta), r * std::sin(theta),
                (a0 + a1 * std::cos(phi)) * 2 * ring::pi / n_azimuths);
        }
      };
      for_graded(whole.first, all_round.first, at);
      for_graded(all_round.first, all_round.second, at);
      for_graded(all_round.second, whole.second, at);
    }

    const LiftedFoot &foot;
    const Eigen::Vector3d position;
    const double lean, direction;

  private:
    static constexpr unsigned int n_azimuths = 1440;

    /// Calls visit(place, weight) at Gauss points graded like x^3 towards both ends, because the integrand
    /// has square roots and kinks at the ends.
    template <typename Visitor>
    static void for_graded(double from, double to, const Visitor &visit)
    {
      using Gauss = boost::math::quadrature::gauss<double, 30>;
      for (std::size_t i = 0; i < Gauss::abscissa().size(); ++i)
        for (const double side : { -1., 1. })
        {
          const double x = (1 + side * Gauss::abscissa()[i]) / 2;
          const double place = x * x * x * (10 - 15 * x + 6 * x * x);
          visit(from + (to - from) * place,
                (to - from) * Gauss::weights()[i] / 2 * 30 * x * x * (1 - x) * (1 - x));
        }
    }
  };

  enum class Friction
  {
    whole,
    first_harmonic
  };

  struct Resultants
  {
    double force = 0;                                   ///< [N]
    Eigen::Vector2d moment = Eigen::Vector2d::Zero();   ///< (sum y f, -sum x f) [N m]
    Eigen::Vector2d friction = Eigen::Vector2d::Zero(); ///< [N]
    double torque = 0;                                  ///< torque of the friction [N m]
  };

  Resultants resultants(const Eigen::Vector3d &position, double omega, Friction part) const
  {
    const Contact contact(*this, position);
    Resultants sum;
    const auto press = [&](double x, double y, double f)
    {
      sum.force += f;
      sum.moment += f * Eigen::Vector2d(y, -x);
    };
    const auto rub = [&](double x, double y, double f)
    {
      const Eigen::Vector2d slip(speed - omega * y, omega * x);
      const Eigen::Vector2d t = -friction * f / slip.norm() * slip;
      sum.friction += t;
      sum.torque += x * t.y() - y * t.x();
    };
    contact.for_each_force(omega,
                           [&](double x, double y, double f)
                           {
                             press(x, y, f);
                             if (part == Friction::whole)
                               rub(x, y, f);
                           });
    if (part == Friction::first_harmonic)
      contact.for_each_force_of_first_harmonic(rub);
    return sum;
  }

  /// Returns the position under the weight and the moment ratio @p m in the direction @p direction [rad].
  Eigen::Vector3d position_at_moment(double m, double direction) const
  {
    const auto residual = [&](double ratio, const Eigen::Vector3d &position)
    {
      const Resultants sum = resultants(position, 1e-3 * speed / contact_radius, Friction::whole);
      const double half = weight() * contact_radius / 2;
      return Eigen::Vector3d(sum.force / weight() - 1, sum.moment.x() / half - ratio * std::sin(direction),
                             sum.moment.y() / half + ratio * std::cos(direction));
    };
    Eigen::Vector3d position = flat_position();
    position.tail<2>() +=
      1e-3 * position(0) / contact_radius * Eigen::Vector2d(std::cos(direction), std::sin(direction));
    const unsigned int n_steps = 20; // the moment grows in small steps
    for (unsigned int i = 1; i <= n_steps; ++i)
      position = solve([&](const Eigen::Vector3d &at) { return residual(m * i / n_steps, at); }, position);
    return position;
  }

  /// Returns the position in moment balance at @p omega, from the initial guess @p position. Throws
  /// std::runtime_error if Newton's method does not converge.
  Eigen::Vector3d position_in_balance(double omega, const Eigen::Vector3d &position, Friction part) const
  {
    const double arm = centre_of_mass_height + force_offset, scale = weight() * contact_radius;
    const double lean_moment = tilts ? weight() * centre_of_mass_height : 0;
    return solve(
      [&](const Eigen::Vector3d &at)
      {
        const Resultants sum = resultants(at, omega, part);
        return Eigen::Vector3d(sum.force / weight() - 1,
                               (sum.moment.x() - force_offset * mass * speed * speed / orbit_radius +
                                arm * sum.friction.y() - lean_moment * at(2)) /
                                 scale,
                               (sum.moment.y() - arm * sum.friction.x() + lean_moment * at(1)) / scale);
      },
      position);
  }

  Eigen::Vector3d flat_position() const
  {
    const double per_depth =
      2 * ring::pi * contact_radius * 4 / 3 * std::sqrt(2 * crown_radius) * foundation_modulus;
    return { std::pow(weight() / per_depth, 2. / 3), 0, 0 };
  }

private:
  template <typename Residual>
  Eigen::Vector3d solve(const Residual &residual, const Eigen::Vector3d &position) const
  {
    const double depth = flat_position()(0);
    return find_position(residual, position, { depth, depth / contact_radius, depth / contact_radius });
  }
};

/// Torque of the glass over the spin. The position at a spin is the initial guess for the next spin.
class LiftedGlass
{
  using Friction = LiftedFoot::Friction;

public:
  /// Creates a glass under a prescribed moment.
  LiftedGlass(const LiftedFoot &foot, double moment_ratio, double direction, Friction part = Friction::whole)
      : foot(foot)
      , part(part)
      , in_balance(false)
      , at_rest(foot.position_at_moment(moment_ratio, direction))
      , position(at_rest)
  {
  }
  /// Creates a glass in moment balance at every spin.
  explicit LiftedGlass(const LiftedFoot &foot, Friction part = Friction::whole)
      : foot(foot)
      , part(part)
      , in_balance(true)
      , at_rest(standing(foot, part))
      , position(at_rest)
  {
  }

  const Eigen::Vector3d &position_at_rest() const { return at_rest; }

  double torque(double omega)
  {
    if (in_balance)
      follow(omega);
    const LiftedFoot::Resultants sum = foot.resultants(position, omega, part);
    const double lean =
      in_balance && foot.tilts ? position(1) * sum.moment.x() + position(2) * sum.moment.y() : 0;
    return sum.torque + lean;
  }

  /// Returns the terminal spin between @p one and @p other [rad/s], in either order.
  double terminal_spin(double one, double other)
  {
    const double least = std::min(one, other), most = std::max(one, other);
    boost::uintmax_t n_steps = 100;
    const auto f = [&](double omega) { return torque(omega); };
    const auto bracket = boost::math::tools::toms748_solve(
      f, least, most, f(least), f(most), boost::math::tools::eps_tolerance<double>(44), n_steps);
    return (bracket.first + bracket.second) / 2;
  }

  double time_constant(double omega, double step = 0.01)
  {
    const double near = torque(omega + step) - torque(omega - step),
                 far = torque(omega + 2 * step) - torque(omega - 2 * step);
    return foot.inertia * 12 * step / std::abs(8 * near - far);
  }

  const LiftedFoot foot;

private:
  static Eigen::Vector3d standing(const LiftedFoot &foot, Friction part)
  {
    LiftedFoot partly = foot;
    Eigen::Vector3d position = foot.flat_position();
    position(1) = 1e-3 * position(0) / foot.contact_radius;
    constexpr unsigned int n_parts = 20;
    for (unsigned int i = 1; i <= n_parts; ++i)
    {
      partly.friction = foot.friction * i / n_parts;
      partly.speed = foot.speed * std::sqrt(static_cast<double>(i) / n_parts);
      position = partly.position_in_balance(rest, position, part);
    }
    return position;
  }

  void follow(double omega)
  {
    const double far = 0.25 * foot.speed / foot.contact_radius / 10;
    while (std::abs(omega - spin) > far)
    {
      spin += omega > spin ? far : -far;
      position = foot.position_in_balance(spin, position, part);
    }
    spin = omega;
    position = foot.position_in_balance(spin, position, part);
  }

  static constexpr double rest = 1e-9;
  const Friction part;
  const bool in_balance;
  const Eigen::Vector3d at_rest;
  Eigen::Vector3d position;
  double spin = rest;
};

} // namespace stemware::verification
