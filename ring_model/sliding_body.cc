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
  return { std::move(rings), 0., largest };
}

SlidingBody SlidingBody::annulus(double inner_radius, double outer_radius)
{
  require(std::isfinite(outer_radius) && inner_radius >= 0. && inner_radius < outer_radius,
          "the annulus reaches from ", inner_radius, " to ", outer_radius,
          " m, but the radii must be finite, not negative and increase");
  return { {}, inner_radius, outer_radius };
}

std::vector<WeightedRing> SlidingBody::rings(double still) const
{
  if (!stacked.empty())
    return stacked;
  std::vector<WeightedRing> nodes;
  nodes.reserve(80);
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

double SlidingBody::mean_square_radius() const
{
  if (stacked.empty())
    return 0.5 * (inner * inner + outer * outer);
  double sum = 0.;
  for (const WeightedRing &one : stacked)
    sum += one.weight * one.radius * one.radius;
  return sum;
}
} // namespace stemware::ring
