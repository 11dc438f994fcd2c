#include "ring_model/unilateral_foundation.h"

#include "ring_model/bracketed_zero.h"
#include "ring_model/load/constants.h"
#include "ring_model/load/require.h"
#include "ring_model/no_balance.h"

#include <boost/math/quadrature/tanh_sinh.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace stemware::ring
{
namespace
{
/// Double exponential quadrature: the integrands have a root or nearly one at an end of the interval.
template <typename Integrand>
double integral(const Integrand &integrand, double upper)
{
  static boost::math::quadrature::tanh_sinh<double> rule;
  return rule.integrate(integrand, 0., upper, 1e-11);
}

/// 1 + kappa cos theta at theta = pi - t: the least value 1 - kappa stands without cancellation.
double full_pressure(double kappa, double t)
{
  const double s = std::sin(0.5 * t);
  return (1. - kappa) + 2. * kappa * s * s;
}

/**
 * (cos theta - c)^p dtheta/dv, up to a factor, with sin(theta/2) = sqrt(s) cos v, s = (1 - c)/2: there
 * cos theta - c = 2 s sin^2 v.
 */
double partial_pressure(double s, double p, double v)
{
  const double sine_squared = std::pow(std::sin(v), 2);
  // The limit at v = 0 also where s = 1 makes the quotient 0/0.
  return sine_squared == 0. ? 0. : std::pow(sine_squared, p + 0.5) / std::sqrt((1. - s) + s * sine_squared);
}

/**
 * Full contact: calls visit(n, a_n / a_{n-1}) for n = n_max...1, with 2 a_0 in a_0's place, from the
 * recurrence (n + 1 + p) a_{n+1} = 2 c n a_n - (n - 1 - p) a_{n-1}. It starts far enough above n_max for the
 * start to die out: |a_n| falls like exp(-n decay), cosh(decay) = -c.
 */
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
} // namespace

UnilateralFoundation::UnilateralFoundation(double radius, double exponent, unsigned int n_harmonics)
    : ring_radius(radius)
    , p(exponent)
    , n_max(n_harmonics)
{
  require_positive(radius, "the ring radius", "m");
  require_positive(exponent, "the foundation's exponent", "");
  require(n_harmonics >= 1, "the number of harmonics is 0, but must be at least 1");
}

double UnilateralFoundation::full_contact_ratio(double kappa) const
{
  const double decay = std::acosh(1. / kappa);
  if (decay > 0.05)
  {
    double ratio = 0.;
    descend(-1. / kappa, p, decay, 1, [&](unsigned int, double value) { ratio = value; });
    return 2. * ratio;
  }
  // By parts, a_1 = p kappa / pi int sin^2 (1 + kappa cos)^{p-1}: positive, and proportional to kappa.
  const double a1 = integral(
    [&](double t)
    {
      const double s = std::sin(t);
      return s * s == 0. ? 0. : s * s * std::pow(full_pressure(kappa, t), p - 1.);
    },
    pi);
  return 2. * p * kappa * a1 / integral([&](double t) { return std::pow(full_pressure(kappa, t), p); }, pi);
}

double UnilateralFoundation::partial_contact_ratio(double s) const
{
  if (p == 1. && s > 0.02)
  {
    // Closed form; for smaller s both differences cancel.
    const double edge_angle = 2. * std::asin(std::sqrt(s)), sine = std::sin(edge_angle), c = 1. - 2. * s;
    return (edge_angle - sine * c) / (sine - edge_angle * c);
  }
  const double deficit =
    integral([&](double v) { return partial_pressure(s, p, v) * std::pow(std::cos(v), 2); }, 0.5 * pi);
  return 2. *
         (1. - 2. * s * deficit / integral([&](double v) { return partial_pressure(s, p, v); }, 0.5 * pi));
}

double UnilateralFoundation::edge(double moment_ratio) const
{
  require(std::isfinite(moment_ratio) && moment_ratio >= 0., "the moment ratio is ", moment_ratio,
          ", but must be finite and not negative");
  if (moment_ratio >= 2.)
    throw Tipping(sentence("the moment ratio is ", moment_ratio,
                           ", but a ring without tension tips at 2; lower the hand's force or slow down"));
  if (moment_ratio == 0.)
    return -std::numeric_limits<double>::infinity();
  const double onset = lift_off_ratio();
  if (moment_ratio == onset)
    return -1.;
  if (p == 1. && moment_ratio < onset)
    return -1. / moment_ratio;
  // Both ratios are monotone.
  const auto zero = [](const auto &excess, double at_0, double at_1)
  { return bracketed_zero(excess, 0., 1., at_0, at_1, "the contact edge"); };
  if (moment_ratio < onset)
    return -1. / zero([&](double kappa) { return full_contact_ratio(kappa) - moment_ratio; }, -moment_ratio,
                      onset - moment_ratio);
  return 1. - 2. * zero([&](double s) { return partial_contact_ratio(s) - moment_ratio; }, 2. - moment_ratio,
                        onset - moment_ratio);
}

std::vector<double> UnilateralFoundation::shape(double moment_ratio) const
{
  const double c = edge(moment_ratio);
  std::vector<double> a(n_max + 1, 0.);
  a[0] = 1.;
  a[1] = moment_ratio;
  if (std::isinf(c) || (p == 1. && c < -1.))
    return a; // full contact on a linear mat is exactly first harmonic
  // (n + 1 + p) a_{n+1} = 2 c n a_n - (n - 1 - p) a_{n-1}, with 2 a_0 in a_0's place.
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

RingStack UnilateralFoundation::rings(double normal_force, const Eigen::Vector2d &moment) const
{
  require_positive(normal_force, "the normal force", "N");
  require(moment.allFinite(), "the moment is (", moment.x(), ", ", moment.y(), ") N m, but must be finite");
  std::vector<double> a = shape(moment.norm() / (0.5 * normal_force * ring_radius));
  while (a.size() > 2 && std::abs(a.back()) < 1e-18)
    a.pop_back(); // harmonics below rounding only cost time
  for (double &coefficient : a)
    coefficient *= normal_force / (2. * pi);
  // M_N = (pi R b_1, -pi R a_1): the load's maximum lies at the angle of (a_1, b_1).
  const double direction = std::atan2(moment.x(), -moment.y());
  std::vector<double> b(a.size(), 0.);
  return RingStack(std::move(a), std::move(b), ring_radius).rotated(direction);
}
} // namespace stemware::ring
