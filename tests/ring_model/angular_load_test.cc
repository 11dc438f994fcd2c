#include "ring_model/angular_load.h"
#include "ring_model/constants.h"
#include "tests/ring_model/reference.h"

#include <limits>
#include <stdexcept>

namespace stemware::ring
{
namespace
{
using test::expect_relative;

/// The message of the std::invalid_argument that building the load throws.
std::string refusal(std::vector<double> a, std::vector<double> b, double radius)
{
  try
  {
    AngularLoad(std::move(a), std::move(b), radius);
  }
  catch (const std::invalid_argument &error)
  {
    return error.what();
  }
  return "accepted";
}

TEST(AngularLoad, ResultantsAreThoseOfThePointwiseLoad)
{
  test::Numbers numbers(1);
  const auto [a, b] = numbers.nonnegative_load(7);
  const AngularLoad load(a, b, 0.04);
  // M_N = sum r x f = (sum y f, -sum x f); the trapezoidal rule is exact for these harmonics.
  double force = 0., moment_x = 0., moment_y = 0.;
  const unsigned int n_points = 32;
  for (unsigned int i = 0; i < n_points; ++i)
  {
    const double theta = 2. * pi * i / n_points, f = load(theta) * 2. * pi / n_points;
    force += f;
    moment_x += 0.04 * std::sin(theta) * f;
    moment_y -= 0.04 * std::cos(theta) * f;
  }
  expect_relative(load.normal_force(), force, 1e-14, "N");
  EXPECT_NEAR(load.moment().x(), moment_x, 1e-15);
  EXPECT_NEAR(load.moment().y(), moment_y, 1e-15);
  expect_relative(load.moment_ratio(), std::hypot(moment_x, moment_y) / (force * 0.04 / 2.), 1e-13, "m");
}

TEST(AngularLoad, FirstHarmonicCarriesItsMoment)
{
  const AngularLoad load = AngularLoad::first_harmonic(2.943, { -0.01225, 0.004 }, 0.03);
  expect_relative(load.normal_force(), 2.943, 1e-15, "N");
  expect_relative(load.moment().x(), -0.01225, 1e-15, "M_x");
  expect_relative(load.moment().y(), 0.004, 1e-15, "M_y");
  EXPECT_EQ(load.n_harmonics(), 1u);
  EXPECT_EQ(load.a(5), 0.);
  expect_relative(load.minimum(), load.a(0) * (1. - load.moment_ratio()), 1e-15, "minimum");
}

TEST(AngularLoad, FindsTheGlobalMinimum)
{
  // a_0 + A cos 4 (theta - t) + a small second harmonic that singles out one of four near-equal minima.
  const double angle = 0.3;
  const AngularLoad load = AngularLoad({ 1., 0., 0., 0., 0.5 }, { 0., 0., 0., 0., 0. }, 1.).rotated(angle);
  expect_relative(load.minimum(), 0.5, 1e-14, "pure fourth harmonic");

  test::Numbers numbers(2);
  for (unsigned int trial = 0; trial < 40; ++trial)
  {
    const auto [a, b] = numbers.nonnegative_load(2 + trial % 15);
    const AngularLoad random(a, b, 0.03);
    double scan = std::numeric_limits<double>::infinity();
    for (unsigned int i = 0; i < 20000; ++i)
      scan = std::min(scan, random(2. * pi * i / 20000.));
    EXPECT_LE(random.minimum(), scan + 1e-15);
    EXPECT_GE(random.minimum(), scan - 1e-5);
  }
}

TEST(AngularLoad, PullsWithItsNegativePart)
{
  // int max(0, -(1 + m cos theta)) dtheta over the arc |theta - pi| < arccos(1/m).
  for (const double m : { 1.0001, 1.2, 1.9, 5. })
  {
    const AngularLoad load({ 2., 2. * m }, { 0., 0. }, 0.03);
    const double pull = 2. * 2. * (std::sqrt(m * m - 1.) - std::acos(1. / m));
    for (const double angle : { 0., 0.5, pi / 16. })
      EXPECT_NEAR(load.rotated(angle).pulling_force(), pull, 1e-13) << m << " turned by " << angle;
  }
  // 1 - 1.5 cos 4 theta turned: four arcs.
  const AngularLoad four({ 1., 0., 0., 0., -1.5 }, { 0., 0., 0., 0., 0. }, 1.);
  EXPECT_NEAR(four.rotated(0.3).pulling_force(), 2. * (std::sqrt(1.25) - std::acos(1. / 1.5)), 1e-14);
  EXPECT_EQ(AngularLoad({ 1., 0.9 }, { 0., 0. }, 1.).pulling_force(), 0.);
  EXPECT_EQ(AngularLoad({ 1. }, { 0. }, 1.).pulling_force(), 0.);
}

TEST(AngularLoad, TurnsMirrorsAndTruncates)
{
  test::Numbers numbers(3);
  const auto [a, b] = numbers.nonnegative_load(6);
  const AngularLoad load(a, b, 0.03);
  const AngularLoad turned = load.rotated(0.7), mirror = load.mirrored(), cut = load.truncated(2);
  for (const double theta : { 0., 0.5, 2., 4. })
  {
    EXPECT_NEAR(turned(theta + 0.7), load(theta), 1e-14);
    EXPECT_NEAR(mirror(-theta), load(theta), 1e-14);
    EXPECT_NEAR(load.derivative(theta), (load(theta + 1e-5) - load(theta - 1e-5)) / 2e-5, 1e-8);
  }
  EXPECT_EQ(cut.n_harmonics(), 2u);
  EXPECT_EQ(cut.b(2), load.b(2));
  EXPECT_EQ(cut.b(3), 0.);
  EXPECT_EQ(load.truncated(50).n_harmonics(), 6u);
}

TEST(AngularLoad, RefusesBadInputWithTheValue)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(refusal({ 1., nan }, { 0., 0. }, 0.03).find("harmonic 1 of the load is (nan"), std::string::npos);
  EXPECT_NE(refusal({ -2., 0. }, { 0., 0. }, 0.03).find("-2"), std::string::npos);
  EXPECT_NE(refusal({ 0. }, { 0. }, 0.03).find("must be positive"), std::string::npos);
  EXPECT_NE(refusal({ 1. }, { 0. }, -0.03).find("-0.03"), std::string::npos);
  EXPECT_NE(refusal({ 1., 2. }, { 0. }, 0.03).find("2 cosine and 1 sine"), std::string::npos);
  EXPECT_NE(refusal({ 1. }, { 0.5 }, 0.03).find("b_0 is 0.5"), std::string::npos);
  EXPECT_NE(refusal({}, {}, 0.03).find("at least one"), std::string::npos);
  EXPECT_THROW(AngularLoad::first_harmonic(1., { nan, 0. }, 0.03), std::invalid_argument);
  EXPECT_THROW(AngularLoad::first_harmonic(-1., { 0., 0. }, 0.03), std::invalid_argument);
}
} // namespace
} // namespace stemware::ring
