#include "ring_model/sliding_body.h"

#include "ring_model/friction_kernels.h"
#include "ring_model/load/constants.h"
#include "ring_model/load/require.h"

#include <boost/math/quadrature/gauss.hpp>

#include <cmath>
#include <utility>

namespace stemware::ring
{
namespace
{
/// Calls add(r, weight) at the points of a 40-point Gauss rule on [lower, upper]. The radius r is a
/// polynomial of the Gauss coordinate whose first three derivatives vanish at both ends, so integrands with
/// end singularities like sqrt(x) or x ln x become smooth.
template <typename Add>
void points_gathered_at_ends(double lower, double upper, const Add &add)
{
  using Rule = boost::math::quadrature::gauss<double, 40>;
  const double length = upper - lower;
  for (unsigned int i = 0; i < Rule::abscissa().size(); ++i)
    for (const double sign : { -1., 1. })
    {
      const double t = 0.5 * (1. + sign * Rule::abscissa()[i]), s = t * (1. - t);
      const double r = t * t * t * t * (35. + t * (-84. + t * (70. - 20. * t)));
      add(lower + length * r, length * 70. * s * s * s * Rule::weights()[i]);
    }
}
} // namespace

SlidingBody::SlidingBody(double inner_radius, double outer_radius)
    : inner(inner_radius)
    , outer(outer_radius)
{
}

SlidingBody SlidingBody::ring(double radius)
{
  require_positive(radius, "the radius of a ring", "m");
  return { radius, radius };
}

SlidingBody SlidingBody::annulus(double inner_radius, double outer_radius)
{
  return with_pressure([](const std::vector<double> &radii) { return std::vector<double>(radii.size(), 1.); },
                       inner_radius, outer_radius);
}

SlidingBody SlidingBody::with_pressure(Pressure pressure, double inner_radius, double outer_radius)
{
  require(std::isfinite(outer_radius) && inner_radius >= 0. && inner_radius < outer_radius,
          "the annulus reaches from ", inner_radius, " to ", outer_radius,
          " m, but the radii must be finite, not negative and increase");
  require(static_cast<bool>(pressure), "the pressure is empty; give a function of the radius");
  SlidingBody body(inner_radius, outer_radius);
  body.pressure = std::move(pressure);
  const double sum = body.mean_power(0.);
  require(sum > 0., "the pressure vanishes from ", inner_radius, " to ", outer_radius,
          " m, but must be positive somewhere");
  body.unit = 1. / sum;
  return body;
}

std::vector<std::pair<double, double>> SlidingBody::rings(double still) const
{
  if (inner == outer)
    return { { outer, 1. } };
  std::vector<double> radii, widths;
  const auto add = [&](double radius, double width)
  {
    radii.push_back(radius);
    widths.push_back(width);
  };
  const bool is_split = inner < still && still < outer;
  points_gathered_at_ends(inner, is_split ? still : outer, add);
  if (is_split)
    points_gathered_at_ends(still, outer, add);
  const std::vector<double> values = pressure(radii);
  require(values.size() == radii.size(), "the pressure has ", values.size(), " values for ", radii.size(),
          " radii; give equally many");
  std::vector<std::pair<double, double>> nodes;
  for (std::size_t i = 0; i < radii.size(); ++i)
  {
    require(std::isfinite(values[i]) && values[i] >= 0., "the pressure at ", radii[i], " m is ", values[i],
            ", but must be finite and not negative");
    nodes.emplace_back(radii[i], unit * values[i] * radii[i] * widths[i]);
  }
  return nodes;
}

double SlidingBody::mean_power(double exponent) const
{
  double sum = 0.;
  for (const auto &[radius, weight] : rings(HUGE_VAL))
    sum += weight * std::pow(radius, exponent);
  return sum;
}

Wrench SlidingBody::friction(double limit, double speed, double omega) const
{
  require_positive(limit, "the friction mu N", "N");
  double drag = 0., torque = 0.;
  for (const auto &[radius, weight] : rings(omega == 0. ? HUGE_VAL : speed / std::abs(omega)))
  {
    const FrictionKernels kernels(omega * radius, speed, 0);
    drag += weight * kernels.U(0);
    torque += weight * radius * kernels.K(0);
  }
  const double scale = limit / (2. * pi);
  return { scale * torque, -scale * drag, 0. };
}
} // namespace stemware::ring
