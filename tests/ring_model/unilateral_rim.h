#pragma once

#include "ring_model/failures.h"
#include "ring_model/friction_functionals.h"
#include "ring_model/load/constants.h"
#include "ring_model/load/ring_stack.h"
#include "ring_model/moment_balance.h"

#include <Eigen/LU>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/math/tools/toms748_solve.hpp>

#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace stemware::ring::test
{
/// Returns the integral from 0 to @p upper. The rule suits integrands that vanish like a root at an end.
template <typename Integrand>
double integral(const Integrand &integrand, double upper)
{
  static boost::math::quadrature::tanh_sinh<double> rule;
  return rule.integrate(integrand, 0., upper, 1e-11);
}

/// Returns 1 + kappa cos theta at theta = pi - t, without cancellation near the minimum 1 - kappa.
inline double full_pressure(double kappa, double t)
{
  const double s = std::sin(0.5 * t);
  return (1. - kappa) + 2. * kappa * s * s;
}

/// Returns (cos theta - c)^p dtheta/dv up to a factor, for sin(theta/2) = sqrt(s) cos v and s = (1 - c)/2.
/// Identity: cos theta - c = 2 s sin^2 v.
inline double partial_pressure(double s, double p, double v)
{
  const double sine_squared = std::pow(std::sin(v), 2);
  // For s = 1 the quotient at v = 0 would be 0/0.
  return sine_squared == 0. ? 0. : std::pow(sine_squared, p + 0.5) / std::sqrt((1. - s) + s * sine_squared);
}

/// Calls visit(n, a_n / a_{n-1}) for n = n_max...1 in full contact, with 2 a_0 in place of a_0. The
/// recurrence (n + 1 + p) a_{n+1} = 2 c n a_n - (n - 1 - p) a_{n-1} runs downwards. It starts far enough
/// above n_max for the error of its initial guess, |a_n| ~ exp(-n decay), to be below rounding.
template <typename Visit>
void descend(double c, double p, double decay, unsigned int n_max, const Visit &visit)
{
  double ratio = -std::exp(-decay);
  for (unsigned int n = n_max + 4 + static_cast<unsigned int>(18. / decay); n >= 1; --n)
  {
    ratio = (n - 1. - p) / (2. * c * n - (n + 1. + p) * ratio);
    if (n <= n_max)
      visit(n, ratio);
  }
}

/// Rigid ring pressed on a foundation without tension under the law lambda(theta) = A max(0, cos(theta -
/// beta) - c)^p, with its maximum at beta. p = 1: flat rim on a linear elastic mat (Winkler); p = 3/2: rim of
/// circular cross-section on a mat. The whole ring is loaded (c < -1) up to the moment ratio 2p/(p+1), a part
/// of the ring up to tipping at m = 2. Derivation: docs/theory/load_models.md.
class UnilateralFoundation
{
public:
  UnilateralFoundation(double radius, double exponent, unsigned int n_harmonics = 128)
      : ring_radius(radius)
      , p(exponent)
      , n_max(n_harmonics)
  {
  }

  double radius() const { return ring_radius; }

  double lift_off_ratio() const { return 2. * p / (p + 1.); }

  /// Returns the load under the given resultants. Throws Tipping as edge().
  RingStack rings(double normal_force, const Eigen::Vector2d &moment) const
  {
    std::vector<double> a = shape(moment.norm() / (0.5 * normal_force * ring_radius));
    for (double &coefficient : a)
      coefficient *= normal_force / (2. * pi);
    // The maximum of the load lies at the angle of (a_1, b_1), and M_N = (pi R b_1, -pi R a_1).
    const double direction = std::atan2(moment.x(), -moment.y());
    std::vector<double> b(a.size(), 0.);
    return RingStack(std::move(a), std::move(b), ring_radius).rotated(direction);
  }

  /// Returns the edge parameter c at the moment ratio m: the cosine of the angle at which contact ends, or
  /// c < -1 for full contact (minus infinity at m = 0). Throws Tipping for m >= 2.
  double edge(double moment_ratio) const
  {
    if (!(moment_ratio < 2.))
      throw Tipping("a ring without tension tips at the moment ratio 2");
    if (moment_ratio == 0.)
      return -std::numeric_limits<double>::infinity();
    const double onset = lift_off_ratio();
    if (moment_ratio == onset)
      return -1.;
    if (p == 1. && moment_ratio < onset)
      return -1. / moment_ratio;
    const auto zero = [](const auto &excess, double at_0, double at_1)
    {
      std::uintmax_t n_steps = 200;
      return boost::math::tools::toms748_solve(excess, 0., 1., at_0, at_1,
                                               boost::math::tools::eps_tolerance<double>(52), n_steps)
        .first;
    };
    if (moment_ratio < onset)
      return -1. / zero([&](double kappa) { return full_contact_ratio(kappa) - moment_ratio; }, -moment_ratio,
                        onset - moment_ratio);
    return 1. - 2. * zero([&](double s) { return partial_contact_ratio(s) - moment_ratio; },
                          2. - moment_ratio, onset - moment_ratio);
  }

  /// Returns a_n / a_0 up to n_max, for the largest load at theta = 0. Throws Tipping as edge().
  std::vector<double> shape(double moment_ratio) const
  {
    const double c = edge(moment_ratio);
    std::vector<double> a(n_max + 1, 0.);
    a[0] = 1.;
    a[1] = moment_ratio;
    if (std::isinf(c) || (p == 1. && c < -1.))
      return a; // on a linear mat (p = 1), full contact has only the first harmonic
    const double decay = c < -1. ? std::acosh(-c) : 0.; // full contact: |a_n| falls like exp(-n decay)
    if (n_max * decay < 1.)
    {
      for (unsigned int n = 1; n < n_max; ++n)
        a[n + 1] = (2. * c * n * a[n] - (n - 1. - p) * (n == 1 ? 2. : a[n - 1])) / (n + 1. + p);
      return a;
    }
    std::vector<double> ratios(n_max + 1, 0.);
    descend(c, p, decay, n_max, [&](unsigned int n, double ratio) { ratios[n] = ratio; });
    for (unsigned int n = 2; n <= n_max; ++n)
      a[n] = ratios[n] * a[n - 1];
    return a;
  }

private:
  /// Returns the moment ratio m in full contact for kappa = -1/c in [0, 1].
  double full_contact_ratio(double kappa) const
  {
    const double decay = std::acosh(1. / kappa);
    if (decay > 0.05)
    {
      double ratio = 0.;
      descend(-1. / kappa, p, decay, 1, [&](unsigned int, double value) { ratio = value; });
      return 2. * ratio;
    }
    // Integration by parts gives a_1 = p kappa / pi int sin^2 (1 + kappa cos)^{p-1}. Its integrand is not
    // negative, so nothing cancels.
    const double a1 = integral(
      [&](double t)
      {
        const double s = std::sin(t);
        return s * s == 0. ? 0. : s * s * std::pow(full_pressure(kappa, t), p - 1.);
      },
      pi);
    return 2. * p * kappa * a1 / integral([&](double t) { return std::pow(full_pressure(kappa, t), p); }, pi);
  }

  /// Returns the moment ratio m with lift-off for s = (1 - c)/2 in (0, 1].
  double partial_contact_ratio(double s) const
  {
    if (p == 1. && s > 0.02)
    {
      // For smaller s, the differences of this closed form suffer from cancellation.
      const double edge_angle = 2. * std::asin(std::sqrt(s)), sine = std::sin(edge_angle), c = 1. - 2. * s;
      return (edge_angle - sine * c) / (sine - edge_angle * c);
    }
    const double deficit =
      integral([&](double v) { return partial_pressure(s, p, v) * std::pow(std::cos(v), 2); }, 0.5 * pi);
    return 2. *
           (1. - 2. * s * deficit / integral([&](double v) { return partial_pressure(s, p, v); }, 0.5 * pi));
  }

  double ring_radius;
  double p;
  unsigned int n_max;
};

/// Rim on a foundation in moment balance M = M_N(T(lambda(M))) at every spin, by Newton's method with
/// difference quotients.
struct BalancedRim
{
  Closure closure;
  Motion motion;
  UnilateralFoundation foundation;

  struct State
  {
    RingStack load;
    Wrench friction;
    double moment_ratio;
  };

  State at(double omega) const
  {
    const double scale = motion.normal_force() * foundation.radius(); // N R
    const auto residual = [&](const Eigen::Vector2d &moment)
    {
      const Wrench friction = wrench(motion, foundation.rings(motion.normal_force(), moment), omega);
      return Eigen::Vector2d(required_moment(closure, motion, { friction.force_x, friction.force_y }) -
                             moment);
    };
    Eigen::Vector2d moment = required_moment_at_rest(closure, motion);
    Eigen::Vector2d change = residual(moment);
    for (int i = 0; i < 20 && change.norm() > 1e-14 * scale; ++i)
    {
      Eigen::Matrix2d jacobian;
      for (int k = 0; k < 2; ++k)
      {
        const Eigen::Vector2d step = 1e-5 * scale * Eigen::Vector2d::Unit(k);
        jacobian.col(k) = (residual(moment + step) - residual(moment - step)) / (2e-5 * scale);
      }
      moment -= jacobian.inverse() * change;
      change = residual(moment);
    }
    RingStack load = foundation.rings(motion.normal_force(), moment);
    const Wrench friction = wrench(motion, load, omega);
    return { std::move(load), friction, moment.norm() / (0.5 * scale) };
  }
};
} // namespace stemware::ring::test
