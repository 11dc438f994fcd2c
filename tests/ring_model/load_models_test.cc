#include "ring_model/constants.h"
#include "ring_model/load_model.h"
#include "ring_model/response_curve.h"
#include "ring_model/unilateral_foundation.h"
#include "tests/ring_model/reference.h"

#include <boost/math/special_functions/gamma.hpp>

#include <limits>
#include <stdexcept>

namespace stemware::ring
{
namespace
{
using test::expect_relative;
using test::reference;

void expect_reference_rows(const char *table, double exponent)
{
  const UnilateralFoundation foundation(0.03, exponent, 16);
  for (const auto &row : reference()[table]["rows"])
  {
    const double m = row["ratio"];
    const std::string name = std::string(table) + " m " + std::to_string(m);
    expect_relative(foundation.edge(m), row["c"], 1e-12, name + " edge");
    EXPECT_EQ(foundation.edge(m) <= -1., row["full_contact"].get<bool>()) << name;
    EXPECT_NEAR(std::acos(std::max(-1., foundation.edge(m))), row["theta_c"].get<double>(), 1e-12) << name;
    expect_relative(foundation.pointwise(m, 0.), row["lambda_max_over_a0"], 1e-12, name + " peak");
    const auto shape = foundation.shape(m);
    for (std::size_t n = 0; n < shape.size(); ++n)
      EXPECT_NEAR(shape[n], row["a_over_a0"][n].get<double>(), 2e-13) << name << " n " << n;
  }
}

TEST(UnilateralFoundation, LinearMatRowsOfTheReference)
{
  expect_reference_rows("contact_winkler_linear", 1.);
}

TEST(UnilateralFoundation, TorusRimRowsOfTheReference)
{
  expect_reference_rows("contact_torus_winkler", 1.5);
}

TEST(UnilateralFoundation, ClosedFormOfTheLinearMat)
{
  const UnilateralFoundation foundation(0.03, 1., 40);
  for (const double edge_angle : { 0.5, 1., pi / 2., 2.5 })
  {
    const double s = std::sin(edge_angle), c = std::cos(edge_angle);
    const double m = (edge_angle - s * c) / (s - edge_angle * c);
    const auto shape = foundation.shape(m);
    for (unsigned int n = 2; n <= 40; ++n)
      EXPECT_NEAR(shape[n],
                  2. * (std::sin(n * edge_angle) * c - n * std::cos(n * edge_angle) * s) /
                    (n * (n * n - 1.) * (s - edge_angle * c)),
                  1e-13)
        << n;
  }
}

TEST(UnilateralFoundation, LiftsOffAtItsOnset)
{
  for (const double p : { 0.5, 1., 1.5, 2., 3.7 })
  {
    const UnilateralFoundation foundation(0.03, p, 8);
    const double onset = foundation.lift_off_ratio();
    EXPECT_DOUBLE_EQ(onset, 2. * p / (p + 1.));
    EXPECT_EQ(foundation.edge(onset), -1.);
    EXPECT_LT(foundation.edge(0.9 * onset), -1.);
    EXPECT_GT(foundation.edge(onset + 0.1 * (2. - onset)), -1.);
    // a_n/a_0 = 2 Gamma(p+1)^2 / (Gamma(p+1+n) Gamma(p+1-n)) at the onset, reached from both sides.
    const double a2 = 2. * p * (p - 1.) / ((p + 1.) * (p + 2.));
    EXPECT_NEAR(foundation.shape(onset)[2], a2, 1e-14) << p;
    EXPECT_NEAR(foundation.shape(onset * (1. - 1e-9))[2], a2, 1e-7) << p;
    EXPECT_NEAR(foundation.shape(onset * (1. + 1e-9))[2], a2, 1e-7) << p;
  }
}

TEST(UnilateralFoundation, CoefficientsAreThoseOfThePointwiseLoad)
{
  // Trapezoidal rule on the pointwise load: an independent projection.
  const double p = 2.5;
  const UnilateralFoundation foundation(0.03, p, 12);
  for (const double m : { 0.3, 1., 1.42, 1.44, 1.7, 1.95 })
  {
    const auto shape = foundation.shape(m);
    const unsigned int n_points = 20000;
    std::vector<double> load(n_points);
    const double c = foundation.edge(m), peak = foundation.pointwise(m, 0.);
    for (unsigned int i = 0; i < n_points; ++i)
      load[i] = peak * std::pow(std::max(0., std::cos(2. * pi * i / n_points) - c) / (1. - c), p);
    for (unsigned int n = 0; n <= 12; ++n)
    {
      double sum = 0.;
      for (unsigned int i = 0; i < n_points; ++i)
        sum += load[i] * std::cos(2. * pi * i * n / n_points);
      EXPECT_NEAR(shape[n], sum * (n == 0 ? 1. : 2.) / n_points, 1e-11) << m << " " << n;
    }
  }
}

TEST(UnilateralFoundation, ApproachesTippingAsAPointLoad)
{
  // m = 2 - theta_c^2 / (2p+3), a_n/a_0 -> 2
  for (const double p : { 1., 1.5 })
  {
    const UnilateralFoundation foundation(0.03, p, 8);
    const double m = 2. - 1e-6;
    expect_relative(std::acos(foundation.edge(m)), std::sqrt((2. * p + 3.) * 1e-6), 1e-3, "edge angle");
    for (unsigned int n = 2; n <= 8; ++n)
      EXPECT_NEAR(foundation.shape(m)[n], 2., 1e-4);
  }
}

TEST(UnilateralFoundation, LoadsHaveTheResultantsAskedFor)
{
  test::Numbers numbers(4);
  for (const double p : { 1., 1.5, 2.2 })
    for (unsigned int trial = 0; trial < 20; ++trial)
    {
      const UnilateralFoundation foundation(0.04, p, 32);
      const double force = numbers.between(0.5, 5.), m = numbers.between(0.01, 1.99),
                   angle = numbers.between(0., 7.);
      const Eigen::Vector2d moment =
        0.5 * m * force * 0.04 * Eigen::Vector2d(std::cos(angle), std::sin(angle));
      const RingStack load = foundation.rings(force, moment);
      expect_relative(load.normal_force(), force, 1e-14, "N");
      EXPECT_LE((load.moment() - moment).norm(), 1e-14 * force * 0.04);
    }
}

TEST(UnilateralFoundation, NamesTippingAndRefusesBadInput)
{
  const UnilateralFoundation foundation(0.03, 1.);
  EXPECT_THROW(foundation.edge(2.), Tipping);
  EXPECT_THROW(foundation.rings(1., { 0.04, 0. }), Tipping);
  EXPECT_THROW(foundation.edge(-0.1), std::invalid_argument);
  EXPECT_THROW(foundation.edge(std::numeric_limits<double>::quiet_NaN()), std::invalid_argument);
  EXPECT_THROW(foundation.rings(0., { 0., 0. }), std::invalid_argument);
  EXPECT_THROW(UnilateralFoundation(0.03, 0.), std::invalid_argument);
  EXPECT_THROW(UnilateralFoundation(-0.03, 1.), std::invalid_argument);
  EXPECT_THROW(UnilateralFoundation(0.03, 1., 0), std::invalid_argument);
}

TEST(FirstHarmonicModel, SaysWhenItTurnsNegative)
{
  const FirstHarmonicModel model(0.03);
  EXPECT_EQ(model.lift_off_ratio(), 1.);
  EXPECT_GT(model.rings(2., { 0.029, 0. }).minimum(), 0.);
  EXPECT_LT(model.rings(2., { 0.031, 0. }).minimum(), 0.);
}

/// Samples of a rim of circular cross-section, each turned differently.
std::vector<RingStack> torus_samples(const std::vector<double> &ratios, double force)
{
  const UnilateralFoundation foundation(0.03, 1.5, 12);
  std::vector<RingStack> samples;
  for (const double m : ratios)
    samples.push_back(
      foundation.rings(force, 0.5 * m * force * 0.03 * Eigen::Vector2d(std::cos(m), std::sin(m))));
  return samples;
}

TEST(ResponseCurve, IsExactAtItsNodesAndSmoothBetween)
{
  std::vector<double> ratios;
  for (unsigned int i = 0; i <= 12; ++i)
    ratios.push_back(0.1 * i);
  const double force = 2.943;
  const ResponseCurve curve(torus_samples(ratios, force), 0.03, 1.2);
  const UnilateralFoundation foundation(0.03, 1.5, 12);
  for (const double m : ratios)
  {
    const RingStack exact = foundation.rings(force, { 0.5 * m * force * 0.03, 0. });
    const RingStack load = curve.rings(force, { 0.5 * m * force * 0.03, 0. });
    for (unsigned int n = 0; n <= 12; ++n)
    {
      EXPECT_NEAR(load.a(n), exact.a(n), 1e-14) << m << " " << n;
      EXPECT_NEAR(load.b(n), exact.b(n), 1e-14) << m << " " << n;
    }
  }
  for (double m = 0.05; m < 1.1; m += 0.1)
  {
    const RingStack exact = foundation.rings(force, { 0., -0.5 * m * force * 0.03 });
    const RingStack load = curve.rings(force, { 0., -0.5 * m * force * 0.03 });
    for (unsigned int n = 0; n <= 12; ++n)
      EXPECT_NEAR(load.a(n), exact.a(n), 5e-5 * exact.a(0)) << m << " " << n;
    EXPECT_NEAR(load.moment().y(), exact.moment().y(), 1e-16);
  }
}

TEST(ResponseCurve, InterpolatesTheRingRadiusToo)
{
  // A wide rim's ring radius grows with the moment ratio; N and M_N stay exact.
  std::vector<RingStack> samples;
  const double force = 2., nominal = 0.03;
  const auto radius = [](double m) { return 0.03 * (1. + 0.01 * m * m); };
  for (const double m : { 0., 0.4, 0.8, 1.2 })
    samples.push_back(RingStack::first_harmonic(force, { 0.5 * m * force * nominal, 0. }, radius(m)));
  const ResponseCurve curve(samples, nominal, 1.);
  const Eigen::Vector2d moment(0., 0.5 * 0.6 * force * nominal);
  const RingStack load = curve.rings(force, moment);
  expect_relative(load.radius(), radius(0.6), 1e-14, "ring radius");
  EXPECT_LE((load.moment() - moment).norm(), 1e-16);
}

TEST(ResponseCurve, InPiecesMeetsAKink)
{
  // At m = 1.2 the rim lifts off. A node there does not help as long as one formula serves both sides.
  const double force = 2.943;
  std::vector<double> below, above;
  for (unsigned int i = 0; i <= 12; ++i)
  {
    below.push_back(0.1 * i);
    above.push_back(1.2 + 0.025 * i);
  }
  std::vector<double> all = below;
  all.insert(all.end(), above.begin() + 1, above.end());
  const ResponseCurve whole(torus_samples(all, force), 0.03, 1.2);
  const ResponseCurve pieces({ torus_samples(below, force), torus_samples(above, force) }, 0.03, 1.2);
  EXPECT_GE(pieces.moment_ratio_limit(), 1.5 * (1. - 1e-14));
  const UnilateralFoundation foundation(0.03, 1.5, 12);
  double worst_whole = 0., worst_pieces = 0.;
  for (double m = 1.05; m < 1.3; m += 0.01)
  {
    const Eigen::Vector2d moment(0.5 * m * force * 0.03, 0.);
    const RingStack exact = foundation.rings(force, moment);
    for (unsigned int n = 0; n <= 12; ++n)
      for (const auto &[curve, worst] : { std::pair{ &whole, &worst_whole }, { &pieces, &worst_pieces } })
        *worst = std::max(*worst, std::hypot(curve->rings(force, moment).a(n) - exact.a(n),
                                             curve->rings(force, moment).b(n) - exact.b(n)) /
                                    exact.a(0));
  }
  EXPECT_LE(worst_pieces, 4e-4);
  EXPECT_GE(worst_whole, 5 * worst_pieces);
  // The pieces meet, and each keeps its nodes.
  for (const double m : { 0.6, 1.2, 1.3, 1.5 })
  {
    const Eigen::Vector2d moment(0., 0.5 * m * force * 0.03 * (1. - 1e-16));
    for (unsigned int n = 0; n <= 12; ++n)
      EXPECT_NEAR(pieces.rings(force, moment).a(n), foundation.rings(force, moment).a(n), 1e-13)
        << m << " " << n;
  }
}

TEST(ResponseCurve, RefusesToExtrapolateAndLoadsThatDependOnMore)
{
  const double force = 2.;
  const auto samples = torus_samples({ 0., 0.5, 1. }, force);
  const ResponseCurve curve(samples, 0.03, 1.2);
  EXPECT_NO_THROW(curve.rings(force, { 0.03, 0. }));
  EXPECT_THROW(curve.rings(force, { 0.0301, 0. }), std::out_of_range);
  EXPECT_THROW(curve.rings(force, { 0.0601, 0. }), Tipping);
  EXPECT_THROW(curve.rings(1.1 * force, { 0.01, 0. }), std::invalid_argument);

  const auto refused = [](std::vector<RingStack> bad, const char *reason)
  {
    try
    {
      const ResponseCurve never(bad, 0.03, 1.2);
      FAIL() << "accepted, but " << reason;
    }
    catch (const std::invalid_argument &error)
    {
      EXPECT_NE(std::string(error.what()).find(reason), std::string::npos) << error.what();
    }
  };
  refused({ samples[0] }, "at least two");
  refused({ samples[1], samples[2] }, "start with a load without moment");
  refused({ samples[0], samples[2], samples[1] }, "must increase");
  EXPECT_THROW(ResponseCurve({ { samples[0], samples[1] }, { samples[2], samples[2] } }, 0.03, 1.2),
               std::invalid_argument);
  EXPECT_THROW(ResponseCurve({ { samples[0], samples[1] }, torus_samples({ 0.6, 0.8 }, force) }, 0.03, 1.2),
               std::invalid_argument);
  refused({ samples[0], torus_samples({ 0.5 }, 1.5)[0] }, "one normal force");
  // A second harmonic that stands across the first: a foot out of round, or friction coupling.
  const double a0 = force / (2. * pi);
  refused({ samples[0], RingStack({ a0, 0.3 * a0, 0. }, { 0., 0., 1e-4 * a0 }, 0.03) },
          "depends on more than the moment ratio");
  refused({ RingStack({ a0, 0., 1e-4 * a0 }, { 0., 0., 0. }, 0.03), samples[1] },
          "depends on more than the moment ratio");
}

TEST(FixedLoad, DoesNotAnswer)
{
  const RingStack load({ 1., 0.3 }, { 0., 0.1 }, 0.03);
  const FixedLoad fixed(load);
  EXPECT_FALSE(fixed.follows_moment());
  EXPECT_EQ(fixed.rings(5., { 1., 1. }).a(1), 0.3);
  EXPECT_EQ(fixed.radius(), 0.03);
  EXPECT_EQ(FixedLoad(RingStack({ 1., 1.3 }, { 0., 0. }, 0.03)).lift_off_ratio(), 0.);
}
} // namespace
} // namespace stemware::ring
