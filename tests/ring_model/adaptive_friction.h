#pragma once

#include "ring_model/friction_functionals.h"
#include "ring_model/load/constants.h"

#include <boost/math/quadrature/gauss_kronrod.hpp>

#include <algorithm>
#include <cmath>

namespace stemware::ring::test
{
/// Slip of the ring's points, psi measured from the point where it is least.
struct AdaptiveSlip
{
  double rim;   ///< |omega| R [m/s]
  double speed; ///< v [m/s]

  /// |v_rel| = sqrt((v - |omega| R)^2 + 4 v |omega| R sin^2(psi/2)), without cancellation.
  double magnitude(double psi) const
  {
    return std::hypot(speed - rim, 2. * std::sqrt(speed * rim) * std::sin(0.5 * psi));
  }
};

/// Integral of @p f(psi) over [0, pi] and the estimate of its error, added to @p error.
template <typename Integrand>
double half_circle(const Integrand &f, const AdaptiveSlip &slip, double tolerance, double &error)
{
  using Rule = boost::math::quadrature::gauss_kronrod<double, 31>;
  const unsigned int max_depth = 12;
  double estimate = 0., sum = 0.;
  const double product = std::sqrt(slip.speed * slip.rim);
  const double width = product > 0. ? std::abs(slip.speed - slip.rim) / product : HUGE_VAL;
  if (width == 0. || width > 1.)
  {
    sum = Rule::integrate(f, 0., pi, max_depth, tolerance, &estimate);
    error += estimate;
    return sum;
  }
  // psi = width sinh y spreads the neighbourhood of the least slip, however narrow, over y of order one each.
  const double end = std::asinh(pi / width);
  const unsigned int n_panels = 1 + static_cast<unsigned int>(end / 3.);
  for (unsigned int i = 0; i < n_panels; ++i)
  {
    sum +=
      Rule::integrate([&](double y) { return f(std::min(pi, width * std::sinh(y))) * width * std::cosh(y); },
                      end * i / n_panels, end * (i + 1) / n_panels, max_depth, tolerance, &estimate);
    error += estimate;
  }
  return sum;
}

/// A wrench with the estimated absolute error of each component, >= 0.
struct EstimatedWrench
{
  Wrench value;
  Wrench error;
};

/**
 * Torque and friction force of one ring under @p law at the spin @p omega [rad/s] and the sliding speed @p
 * speed [m/s] by adaptive Gauss-Kronrod quadrature in a variable that resolves the point of least slip at
 * every slip ratio: it says how well, and shares no quadrature with friction_functionals().
 */
inline EstimatedWrench adaptive_wrench(const FrictionLaw &law, const RingStack &load, double omega,
                                       double speed, double tolerance = 1e-12)
{
  // psi = theta -+ 90 deg from the point of least slip; the slip is even in psi, so the load is split
  // likewise.
  const double sense = omega < 0. ? -1. : 1.;
  const AdaptiveSlip slip{ std::abs(omega) * load.radius(), speed };
  const auto even = [&](double psi) { return load(sense * 0.5 * pi + psi) + load(sense * 0.5 * pi - psi); };
  const auto odd = [&](double psi) { return load(sense * 0.5 * pi + psi) - load(sense * 0.5 * pi - psi); };
  const auto friction_per_slip = [&](double psi)
  {
    const double magnitude = slip.magnitude(psi);
    return magnitude > 0. ? law.coefficient(magnitude) / magnitude : 0.;
  };
  // v cos psi - |omega| R and v - |omega| R cos psi from half angles.
  const auto spin_part = [&](double psi)
  { return (slip.speed - slip.rim) - 2. * slip.speed * std::pow(std::sin(0.5 * psi), 2); };
  const auto drag_part = [&](double psi)
  { return (slip.speed - slip.rim) + 2. * slip.rim * std::pow(std::sin(0.5 * psi), 2); };

  EstimatedWrench result{ { 0., 0., 0. }, { 0., 0., 0. } };
  result.value.torque =
    sense * load.radius() *
    half_circle([&](double psi) { return even(psi) * friction_per_slip(psi) * spin_part(psi); }, slip,
                tolerance, result.error.torque);
  result.error.torque *= load.radius();
  result.value.force_x =
    -half_circle([&](double psi) { return even(psi) * friction_per_slip(psi) * drag_part(psi); }, slip,
                 tolerance, result.error.force_x);
  // v_rel,y = omega R cos theta = -|omega| R sin psi.
  result.value.force_y =
    half_circle([&](double psi) { return odd(psi) * friction_per_slip(psi) * slip.rim * std::sin(psi); },
                slip, tolerance, result.error.force_y);
  return result;
}
} // namespace stemware::ring::test
