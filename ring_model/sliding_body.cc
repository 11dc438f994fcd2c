#include "ring_model/sliding_body.h"

#include "ring_model/load/require.h"

#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace stemware::ring
{
namespace
{
/// Calls add(x, weight) for the 40-point Gauss rule on [lower, upper].
template <typename Add>
void gauss_points(double lower, double upper, const Add &add)
{
  using Rule = boost::math::quadrature::gauss<double, 40>;
  const double middle = 0.5 * (lower + upper), half = 0.5 * (upper - lower);
  for (unsigned int i = 0; i < Rule::abscissa().size(); ++i)
    for (const double sign : { -1., 1. })
      add(middle + sign * half * Rule::abscissa()[i], half * Rule::weights()[i]);
}

/// Calls add(r, weight) for a Gauss rule on [lower, upper] whose points gather at both ends: r runs as a
/// polynomial of t with three vanishing derivatives there, so that a root of the distance becomes smooth.
template <typename Add>
void points_gathered_at_ends(double lower, double upper, const Add &add)
{
  const double length = upper - lower;
  gauss_points(0., 1.,
               [&](double t, double width)
               {
                 const double s = t * (1. - t), r = t * t * t * t * (35. + t * (-84. + t * (70. - 20. * t)));
                 add(lower + length * r, length * 140. * s * s * s * width);
               });
}

/// Throws unless an annulus reaches from one radius to a larger one.
void require_annulus(double inner_radius, double outer_radius)
{
  require(std::isfinite(outer_radius) && inner_radius >= 0. && inner_radius < outer_radius,
          "the annulus reaches from ", inner_radius, " to ", outer_radius,
          " m, but the radii must be finite, not negative and increase");
}
} // namespace

SlidingBody::SlidingBody(std::vector<WeightedRing> stacked, double inner_radius, double outer_radius)
    : stacked(std::move(stacked))
    , inner(inner_radius)
    , outer(outer_radius)
{
}

SlidingBody SlidingBody::ring(double radius)
{
  return stack({ { radius, 1. } });
}

SlidingBody SlidingBody::stack(std::vector<WeightedRing> rings)
{
  require(!rings.empty(), "the body has no rings, but needs at least one");
  double sum = 0., largest = 0.;
  for (const WeightedRing &one : rings)
  {
    require_positive(one.radius, "the radius of a ring", "m");
    require_positive(one.weight, "the weight of a ring", "of 1");
    sum += one.weight;
    largest = std::max(largest, one.radius);
  }
  require(std::abs(sum - 1.) <= 1e-12, "the weights of the rings add up to ", sum, ", but must add up to 1");
  SlidingBody body(std::move(rings), 0., largest);
  body.mean_square = body.mean_power(2.);
  return body;
}

SlidingBody SlidingBody::annulus(double inner_radius, double outer_radius)
{
  require_annulus(inner_radius, outer_radius);
  SlidingBody body({}, inner_radius, outer_radius);
  body.mean_square = 0.5 * (inner_radius * inner_radius + outer_radius * outer_radius);
  return body;
}

SlidingBody SlidingBody::with_pressure(Pressure pressure, double inner_radius, double outer_radius)
{
  require_annulus(inner_radius, outer_radius);
  require(static_cast<bool>(pressure), "the pressure is empty; give a function of the radius");
  SlidingBody body({}, inner_radius, outer_radius);
  body.pressure = std::move(pressure);
  double sum = 0.;
  for (const WeightedRing &one : body.rings(HUGE_VAL))
    sum += one.weight;
  require(sum > 0., "the pressure vanishes from ", inner_radius, " to ", outer_radius,
          " m, but must be positive somewhere");
  body.unit = 1. / sum;
  body.mean_square = body.mean_power(2.);
  return body;
}

std::vector<WeightedRing> SlidingBody::rings(double still) const
{
  if (!stacked.empty())
    return stacked;
  std::vector<WeightedRing> nodes;
  nodes.reserve(80);
  if (pressure)
  {
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
    for (std::size_t i = 0; i < radii.size(); ++i)
    {
      require(std::isfinite(values[i]) && values[i] >= 0., "the pressure at ", radii[i], " m is ", values[i],
              ", but must be finite and not negative");
      nodes.push_back({ radii[i], unit * values[i] * radii[i] * widths[i] });
    }
    return nodes;
  }
  const double area = 0.5 * (outer - inner) * (outer + inner);
  const auto add = [&](double radius, double width) { nodes.push_back({ radius, radius * width / area }); };
  if (!(still < 2. * outer) || still < 0.25 * inner)
  {
    gauss_points(inner, outer, add);
    return nodes;
  }
  // r = still +- t^3 on either side: x ln x becomes t^5 ln t under the integral.
  const auto side = [&](double sign, double nearest, double farthest)
  {
    gauss_points(std::cbrt(nearest), std::cbrt(farthest),
                 [&](double t, double width) { add(still + sign * t * t * t, 3. * t * t * width); });
  };
  if (still > inner)
    side(-1., std::max(still - outer, 0.), still - inner);
  if (still < outer)
    side(1., std::max(inner - still, 0.), outer - still);
  return nodes;
}

double SlidingBody::mean_power(double exponent) const
{
  double sum = 0.;
  for (const WeightedRing &one : rings(HUGE_VAL))
    sum += one.weight * std::pow(one.radius, exponent);
  return sum;
}
} // namespace stemware::ring
