#include "ring_model/friction_law.h"

#include "ring_model/friction_kernels.h"
#include "ring_model/load/constants.h"
#include "ring_model/load/require.h"

#include <Eigen/Core>
#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <cmath>

namespace stemware::ring
{
StribeckLaw::StribeckLaw(double static_coefficient, double kinetic_coefficient, double decay_speed,
                         double viscous, double decay_exponent)
    : static_coefficient(static_coefficient)
    , kinetic_coefficient(kinetic_coefficient)
    , decay_speed(decay_speed)
    , viscous(viscous)
    , decay_exponent(decay_exponent)
{
  for (const double coefficient : { static_coefficient, kinetic_coefficient, viscous })
    require(std::isfinite(coefficient) && coefficient >= 0., "a coefficient of the friction law is ",
            coefficient, ", but must be finite and not negative");
  require_positive(decay_speed, "the decay speed of Stribeck's law", "m/s");
  require_positive(decay_exponent, "the decay exponent of Stribeck's law", "");
}

double StribeckLaw::coefficient(double slip_speed) const
{
  const double ratio = slip_speed / decay_speed;
  const double decay = std::exp(-(decay_exponent == 2. ? ratio * ratio : std::pow(ratio, decay_exponent)));
  return kinetic_coefficient + (static_coefficient - kinetic_coefficient) * decay + viscous * slip_speed;
}

bool StribeckLaw::is_constant() const
{
  return static_coefficient == kinetic_coefficient && viscous == 0.;
}

namespace
{
/// Speeds of the rim's points, |omega| R, and of the ring's centre, v [m/s].
struct SlipField
{
  double rim;
  double speed;
};

/// Quadrature points psi on half the rim, measured from the point of minimum slip, and their weights.
struct HalfRim
{
  Eigen::ArrayXd psi;
  Eigen::ArrayXd weight;
};

/// Returns the trapezoidal rule, whose error decreases exponentially if the slip vanishes nowhere.
HalfRim even_places(unsigned int n_intervals)
{
  HalfRim places{ Eigen::ArrayXd::LinSpaced(n_intervals + 1, 0., pi),
                  Eigen::ArrayXd::Constant(n_intervals + 1, pi / n_intervals) };
  places.weight(0) *= 0.5;
  places.weight(n_intervals) *= 0.5;
  return places;
}

/// Returns the midpoint rule. Its mean with even_places() is the trapezoidal rule of 2 n_intervals intervals.
HalfRim places_between(unsigned int n_intervals)
{
  const double half = 0.5 * pi / n_intervals;
  return { Eigen::ArrayXd::LinSpaced(n_intervals, half, pi - half),
           Eigen::ArrayXd::Constant(n_intervals, pi / n_intervals) };
}

/// Returns Gauss rules on panels of equal length in y, where psi = @p width sinh y (psi = y if @p width is
/// 0). The points are thus densest at the minimum slip, psi = 0. No panel is longer than @p longest in psi.
HalfRim clustered_places(double width, unsigned int n_panels, double longest)
{
  using Rule = boost::math::quadrature::gauss<double, 20>;
  std::vector<double> ends{ 0. };
  const double end = width > 0. ? std::asinh(pi / width) : pi;
  const auto psi_at = [&](double y) { return width > 0. ? width * std::sinh(y) : y; };
  for (unsigned int i = 1; i <= n_panels; ++i)
  {
    const double from = end * (i - 1) / n_panels, to = end * i / n_panels;
    const auto n_parts = static_cast<unsigned int>(std::ceil((psi_at(to) - psi_at(from)) / longest));
    for (unsigned int part = 1; part <= std::max(n_parts, 1u); ++part)
      ends.push_back(from + (to - from) * part / std::max(n_parts, 1u));
  }
  const std::size_t n_half = Rule::abscissa().size();
  HalfRim places{ Eigen::ArrayXd((ends.size() - 1) * 2 * n_half),
                  Eigen::ArrayXd((ends.size() - 1) * 2 * n_half) };
  Eigen::Index k = 0;
  for (std::size_t panel = 1; panel < ends.size(); ++panel)
    for (std::size_t i = 0; i < n_half; ++i)
      for (const double sign : { -1., 1. })
      {
        const double half = 0.5 * (ends[panel] - ends[panel - 1]);
        const double y = ends[panel - 1] + half * (1. + sign * Rule::abscissa()[i]);
        places.psi(k) = std::min(pi, psi_at(y));
        places.weight(k++) = half * Rule::weights()[i] * (width > 0. ? width * std::cosh(y) : 1.);
      }
  return places;
}

/// Returns friction integrals per unit load. Row n: harmonic n. Columns: torque / r, drag, side force.
Eigen::ArrayX3d law_kernels(const FrictionLaw &law, const SlipField &slip, const HalfRim &places,
                            unsigned int n_max)
{
  const Eigen::ArrayXd sine_of_half = (0.5 * places.psi).sin(), half_sine = sine_of_half.square();
  const Eigen::ArrayXd sine_of_psi = 2. * sine_of_half * (0.5 * places.psi).cos();
  Eigen::ArrayXd per_slip(places.psi.size());
  for (Eigen::Index i = 0; i < places.psi.size(); ++i)
  {
    // |v_rel| = sqrt((v - |omega| R)^2 + 4 v |omega| R sin^2(psi/2)), without cancellation.
    const double magnitude =
      std::hypot(slip.speed - slip.rim, 2. * std::sqrt(slip.speed * slip.rim) * sine_of_half(i));
    per_slip(i) = magnitude > 0. ? 2. * places.weight(i) * law.coefficient(magnitude) / magnitude : 0.;
  }
  const Eigen::ArrayXd torque = per_slip * ((slip.speed - slip.rim) - 2. * slip.speed * half_sine);
  const Eigen::ArrayXd drag = per_slip * ((slip.speed - slip.rim) + 2. * slip.rim * half_sine);
  const Eigen::ArrayXd side = per_slip * slip.rim * sine_of_psi;
  Eigen::ArrayX3d kernels(n_max + 1, 3);
  // Three-term recurrence for cos n psi and sin n psi: c_{n+1} = 2 cos(psi) c_n - c_{n-1}.
  const Eigen::ArrayXd twice = 2. - 4. * half_sine;
  Eigen::ArrayXd cosine = Eigen::ArrayXd::Ones(places.psi.size()), cosine_before = 0.5 * twice;
  Eigen::ArrayXd sine = Eigen::ArrayXd::Zero(places.psi.size()), sine_before = -sine_of_psi;
  for (unsigned int n = 0; n <= n_max; ++n)
  {
    kernels.row(n) << (torque * cosine).sum(), (drag * cosine).sum(), (side * sine).sum();
    cosine_before = twice * cosine - cosine_before;
    cosine.swap(cosine_before);
    sine_before = twice * sine - sine_before;
    sine.swap(sine_before);
  }
  return kernels;
}

Eigen::ArrayX3d converged_kernels(const FrictionLaw &law, const SlipField &slip, unsigned int n_max)
{
  constexpr unsigned int max_doublings = 8;
  constexpr double near_stagnation = 0.25; // the trapezoidal rule converges slowly if `width` is smaller
  const double product = std::sqrt(slip.speed * slip.rim);
  const double width = product > 0. ? std::abs(slip.speed - slip.rim) / product : HUGE_VAL;
  const bool is_smooth = width > near_stagnation;
  const unsigned int n_even = 32 + n_max;
  const auto clustered = [&](unsigned int level)
  {
    const unsigned int factor = 1u << level;
    return clustered_places(
      width, factor * (2 + static_cast<unsigned int>(width > 0. ? std::asinh(pi / width) : 1.)),
      4. * pi / std::max(n_max, 2u) / factor);
  };
  Eigen::ArrayX3d kernels = law_kernels(law, slip, is_smooth ? even_places(n_even) : clustered(0), n_max);
  for (unsigned int level = 1; level <= max_doublings; ++level)
  {
    const Eigen::ArrayX3d before = kernels;
    if (is_smooth)
      kernels = 0.5 * (before + law_kernels(law, slip, places_between(n_even << (level - 1)), n_max));
    else
      kernels = law_kernels(law, slip, clustered(level), n_max);
    if ((kernels - before).abs().maxCoeff() <= 1e-12 * kernels.abs().maxCoeff())
      return kernels;
  }
  throw std::runtime_error(sentence("friction at v = ", slip.speed, " m/s and a rim of ", slip.rim,
                                    " m/s did not converge: its coefficient changes within too little slip; "
                                    "give a larger decay speed"));
}
} // namespace

StribeckLaw friction_law_of(const Motion &motion)
{
  const double mu = motion.friction_coefficient;
  if (motion.friction_law == FrictionLawKind::coulomb)
    return coulomb_law(mu);
  return { motion.static_coefficient, mu, motion.friction_decay_speed, motion.viscous_friction };
}

Eigen::ArrayX3d friction_kernels(const FrictionLaw &law, double rim_speed, double speed, unsigned int n_max)
{
  Eigen::ArrayX3d kernels(n_max + 1, 3);
  const FrictionKernels exact(rim_speed, speed, law.is_constant() ? n_max : 0);
  if (law.is_constant())
  {
    for (unsigned int n = 0; n <= n_max; ++n)
      kernels.row(n) << exact.K(n), exact.U(n), n > 0 ? -(n * exact.P(n)) : 0.;
    return law.coefficient(0.) * kernels;
  }
  kernels = converged_kernels(law, { std::abs(rim_speed), speed }, n_max);
  // For omega < 0 the minimum slip is at theta = -90 deg instead of 90 deg, so some kernels change sign.
  if (rim_speed < 0.)
    for (unsigned int n = 0; n <= n_max; ++n)
      kernels.row(n) *=
        n % 2 == 0 ? Eigen::Array<double, 1, 3>(-1., 1., 1.) : Eigen::Array<double, 1, 3>(1., -1., -1.);
  return kernels;
}
} // namespace stemware::ring
