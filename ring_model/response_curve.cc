#include "ring_model/response_curve.h"

#include "ring_model/require.h"

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace stemware::ring
{
namespace
{
constexpr double pi = boost::math::constants::pi<double>();

/// Moment ratio with the nominal radius.
double ratio_of(const AngularLoad &load, double nominal_radius)
{
  return load.moment().norm() / (0.5 * load.normal_force() * nominal_radius);
}

/// The load turned so that its first harmonic is a pure cosine.
AngularLoad aligned(const AngularLoad &load)
{
  return load.rotated(-std::atan2(load.b(1), load.a(1)));
}

/// Refuses harmonics that are not symmetric about theta = 0; without moment, any harmonics.
void check_harmonics(const AngularLoad &load, std::size_t index, bool without_moment, double tolerance)
{
  for (unsigned int n = 1; n <= load.n_harmonics(); ++n)
    require(std::abs(load.b(n)) <= tolerance * load.a(0) &&
              (!without_moment || std::abs(load.a(n)) <= tolerance * load.a(0)),
            "harmonic ", n, " of sample ", index, " is (", load.a(n), ", ", load.b(n),
            ") N/rad about the direction of its moment, not symmetric to ", tolerance,
            " a_0: this load depends on more than the moment ratio (a foot that is no body of revolution, or "
            "friction "
            "coupling); solve the contact at every state instead");
}

/// Interpolant through (m_i, y_i) and their mirror images (-m_i, parity y_i); m_0 = 0.
boost::math::barycentric_rational<double>
mirrored_interpolant(const std::vector<double> &ratios, const std::vector<double> &values, double parity)
{
  std::vector<double> x, y;
  for (std::size_t i = ratios.size() - 1; i > 0; --i)
  {
    x.push_back(-ratios[i]);
    y.push_back(parity * values[i]);
  }
  x.insert(x.end(), ratios.begin(), ratios.end());
  y.insert(y.end(), values.begin(), values.end());
  const std::size_t order = std::min<std::size_t>(5, x.size() - 1);
  return { std::move(x), std::move(y), order };
}
} // namespace

ResponseCurve::ResponseCurve(const std::vector<AngularLoad> &samples, double nominal_radius,
                             double lift_off_ratio, double tolerance)
    : nominal(nominal_radius)
    , onset(lift_off_ratio)
    , force(0.)
    , last_ratio(0.)
{
  require_positive(nominal_radius, "the nominal radius", "m");
  require(lift_off_ratio > 0., "the lift-off ratio is ", lift_off_ratio, ", but must be positive");
  require(samples.size() >= 2, "the response curve has ", samples.size(), " samples, but needs at least two");
  force = samples.front().normal_force();

  // Without moment a body of revolution has no harmonics, and no direction to turn the load to.
  require(ratio_of(samples[0], nominal) < tolerance, "the response curve starts at the moment ratio ",
          ratio_of(samples[0], nominal), ", but must start with a load without moment");
  check_harmonics(samples[0], 0, true, tolerance);
  std::vector<double> ratios{ 0. }, radii{ samples[0].radius() };
  std::vector<AngularLoad> shapes{ samples[0].truncated(0) };
  unsigned int n_max = 1;
  for (std::size_t i = 1; i < samples.size(); ++i)
  {
    const double ratio = ratio_of(samples[i], nominal);
    require(ratio > ratios.back(), "sample ", i, " has the moment ratio ", ratio, " after ", ratios.back(),
            ", but the ratios must increase");
    require(std::abs(samples[i].normal_force() - force) <= 1e-9 * force, "sample ", i,
            " has the normal force ", samples[i].normal_force(), " N, but the first has ", force,
            " N: a curve over the moment ratio needs one normal force");
    shapes.push_back(aligned(samples[i]));
    check_harmonics(shapes.back(), i, false, tolerance);
    ratios.push_back(ratio);
    radii.push_back(samples[i].radius());
    n_max = std::max(n_max, samples[i].n_harmonics());
  }
  last_ratio = ratios.back();

  for (unsigned int n = 2; n <= n_max; ++n)
  {
    std::vector<double> values;
    values.reserve(shapes.size());
    for (const AngularLoad &shape : shapes)
      values.push_back(shape.a(n) / shape.a(0));
    harmonics.push_back(mirrored_interpolant(ratios, values, n % 2 == 0 ? 1. : -1.));
  }
  ring_radius.push_back(mirrored_interpolant(ratios, radii, 1.));
}

double ResponseCurve::moment_ratio_limit() const
{
  return std::min(2., std::nextafter(last_ratio, 2.));
}

AngularLoad ResponseCurve::load(double normal_force, const Eigen::Vector2d &moment) const
{
  require(std::abs(normal_force - force) <= 1e-9 * force, "the normal force is ", normal_force,
          " N, but the response curve was computed for ", force, " N");
  require(moment.allFinite(), "the moment is (", moment.x(), ", ", moment.y(), ") N m, but must be finite");
  const double ratio = moment.norm() / (0.5 * normal_force * nominal);
  if (ratio >= 2.)
    throw Tipping(sentence("the moment ratio is ", ratio, ", but a ring that cannot pull tips at 2"));
  if (ratio > last_ratio * (1. + 1e-14))
    throw std::out_of_range(sentence("the moment ratio is ", ratio, ", but the response curve ends at ",
                                     last_ratio, ": add contact solutions up to there"));
  const double a0 = normal_force / (2. * pi), ring = ring_radius[0](ratio);
  std::vector<double> a{ a0, moment.norm() / (pi * ring) };
  for (const auto &harmonic : harmonics)
    a.push_back(a0 * harmonic(ratio));
  std::vector<double> b(a.size(), 0.);
  return AngularLoad(std::move(a), std::move(b), ring).rotated(std::atan2(moment.x(), -moment.y()));
}
} // namespace stemware::ring
