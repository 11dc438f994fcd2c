#include "ring_model/friction_law.h"

#include "ring_model/constants.h"
#include "ring_model/require.h"

#include <boost/math/quadrature/gauss_kronrod.hpp>

#include <algorithm>
#include <cmath>

namespace stemware::ring
{
namespace
{
/// Slip of the ring's points, psi measured from the point where it is least.
struct SlipField
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
double half_circle(const Integrand &f, const SlipField &slip, double tolerance, double &error)
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
} // namespace

CoulombLaw::CoulombLaw(double friction_coefficient)
    : mu(friction_coefficient)
{
  require(std::isfinite(mu) && mu >= 0., "the friction coefficient is ", mu,
          ", but must be finite and not negative");
}

StribeckLaw::StribeckLaw(const Parameters &parameters)
    : parameters(parameters)
{
  for (const double coefficient :
       { parameters.static_coefficient, parameters.kinetic_coefficient, parameters.viscous })
    require(std::isfinite(coefficient) && coefficient >= 0., "a coefficient of Stribeck's law is ",
            coefficient, ", but must be finite and not negative");
  require_positive(parameters.decay_speed, "the decay speed of Stribeck's law", "m/s");
  require_positive(parameters.decay_exponent, "the decay exponent of Stribeck's law", "");
}

double StribeckLaw::coefficient(double slip_speed) const
{
  const double decay = std::exp(-std::pow(slip_speed / parameters.decay_speed, parameters.decay_exponent));
  return parameters.kinetic_coefficient +
         (parameters.static_coefficient - parameters.kinetic_coefficient) * decay +
         parameters.viscous * slip_speed;
}

bool StribeckLaw::is_constant() const
{
  return parameters.static_coefficient == parameters.kinetic_coefficient && parameters.viscous == 0.;
}

EstimatedWrench wrench(const FrictionLaw &law, const RingStack &load, double omega, double speed,
                       double tolerance)
{
  if (law.is_constant())
    return { CoulombRing(law.coefficient(0.)).wrench(load, omega, speed), { 0., 0., 0. } };
  require_positive(tolerance, "the requested accuracy", "");
  require(std::isfinite(omega) && std::isfinite(speed) && speed >= 0. && (omega != 0. || speed > 0.),
          "the ring slides with ", speed, " m/s and spins with ", omega,
          " rad/s, but both must be finite, the speed not negative and one of them not zero");

  // psi = theta -+ 90 deg from the point of least slip; the slip is even in psi, so the load is split
  // likewise.
  const double sense = omega < 0. ? -1. : 1.;
  const SlipField slip{ std::abs(omega) * load.radius(), speed };
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

  const double scale = law.coefficient(slip.speed + slip.rim) * load.normal_force();
  const double worst =
    std::max({ result.error.torque / load.radius(), result.error.force_x, result.error.force_y });
  if (!(worst <= 10. * tolerance * std::max(scale, std::abs(result.value.force_x))))
    throw std::runtime_error(sentence("friction by quadrature at v = ", speed, " m/s, omega = ", omega,
                                      " rad/s has the estimated error ", worst,
                                      " N, more than ten times the tolerance ", tolerance, " asked for"));
  return result;
}
} // namespace stemware::ring
