#include "ring_model/friction_functionals.h"
#include "ring_model/load/constants.h"
#include "ring_model/load/load_functional.h"
#include "ring_model/load/ring_stack.h"
#include "ring_model/spin/sample.h"
#include "tests/ring_model/quadrature.h"
#include "tests/ring_model/reference.h"
#include "tests/taylor_remainder.h"
#include "tests/ulps.h"

#include <limits>
#include <stdexcept>
#include <tuple>
#include <vector>

namespace stemware::ring
{
namespace
{

TEST(RingStack, ResultantsAgreeWithThePointwiseLoad)
{
  test::Numbers numbers(1);
  const RingStack load = numbers.nonnegative_load(7, 0.04);
  // Reference: M_N = (sum y f, -sum x f). The trapezoidal rule is exact for these harmonics.
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
  EXPECT_NEAR(load.moment().x(), moment_x, ulps(18, force * 0.04));
  EXPECT_NEAR(load.moment().y(), moment_y, ulps(18, force * 0.04));
  expect_relative(load.moment_ratio(0.04), std::hypot(moment_x, moment_y) / (force * 0.04 / 2.), 1e-13, "m");
}

TEST(RingStack, FirstHarmonicLoadHasThePrescribedResultantsAndTheExactMinimum)
{
  const RingStack load = RingStack::first_harmonic(2.943, { -0.01225, 0.004 }, 0.03);
  expect_relative(load.normal_force(), 2.943, 1e-15, "N");
  expect_relative(load.moment().x(), -0.01225, 1e-15, "M_x");
  expect_relative(load.moment().y(), 0.004, 1e-15, "M_y");
  EXPECT_EQ(load.n_harmonics(), 1u);
  EXPECT_EQ(load.a(5), 0.);
  expect_relative(load.minimum(), load.a(0) * (1. - load.moment_ratio(load.radius())), 1e-15, "minimum");
}

TEST(RingStack, FindsTheGlobalMinimum)
{

  const double angle = 0.3;
  const RingStack load = RingStack({ 1., 0., 0., 0., 0.5 }, { 0., 0., 0., 0., 0. }, 1.).rotated(angle);
  expect_relative(load.minimum(), 0.5, 1e-14, "pure fourth harmonic");

  test::Numbers numbers(2);
  for (unsigned int trial = 0; trial < 40; ++trial)
  {
    const RingStack random = numbers.nonnegative_load(2 + trial % 15);
    double scan = std::numeric_limits<double>::infinity();
    for (unsigned int i = 0; i < 20000; ++i)
      scan = std::min(scan, random(2. * pi * i / 20000.));
    EXPECT_LE(random.minimum(), scan + ulps(5, scan));
    EXPECT_GE(random.minimum(), scan - 1e-5);
  }
}

TEST(RingStack, TensileForceIsTheIntegralOfTheNegativePart)
{
  // Closed form: int max(0, -(1 + m cos theta)) dtheta over the arc |theta - pi| < arccos(1/m).
  for (const double m : { 1.0001, 1.2, 1.9, 5. })
  {
    const RingStack load({ 2., 2. * m }, { 0., 0. }, 0.03);
    const double pull = 2. * 2. * (std::sqrt(m * m - 1.) - std::acos(1. / m));
    for (const double angle : { 0., 0.5, pi / 16. })
      EXPECT_NEAR(load.rotated(angle).pulling_force(), pull, 1e-13) << m << " turned by " << angle;
  }
  // The rotated load 1 - 1.5 cos 4 theta has four tensile arcs.
  const RingStack four({ 1., 0., 0., 0., -1.5 }, { 0., 0., 0., 0., 0. }, 1.);
  EXPECT_NEAR(four.rotated(0.3).pulling_force(), 2. * (std::sqrt(1.25) - std::acos(1. / 1.5)), 1e-14);
  EXPECT_EQ(RingStack({ 1., 0.9 }, { 0., 0. }, 1.).pulling_force(), 0.);
  EXPECT_EQ(RingStack({ 1. }, { 0. }, 1.).pulling_force(), 0.);
}

TEST(RingStack, RotationMirrorImageTruncationAndDerivativeAreCorrect)
{
  test::Numbers numbers(3);
  const RingStack load = numbers.nonnegative_load(6);
  const RingStack turned = load.rotated(0.7), mirror = test::mirrored(load), cut = load.truncated(2);
  for (const double theta : { 0., 0.5, 2., 4. })
  {
    EXPECT_NEAR(turned(theta + 0.7), load(theta), 1e-14);
    EXPECT_NEAR(mirror(-theta), load(theta), 1e-14);
    EXPECT_TRUE(
      taylor::is_derivative([&](double h) { return load(theta + h); }, load.derivative(theta), 0.1));
  }
  EXPECT_EQ(cut.n_harmonics(), 2u);
  EXPECT_EQ(cut.b(2), load.b(2));
  EXPECT_EQ(cut.b(3), 0.);
  EXPECT_EQ(load.truncated(50).n_harmonics(), 6u);
}

RingStack three_rings()
{
  return RingStack({ { 0.028, { 0.3, 0.1, 0.02 }, { 0., 0.05, -0.01 } },
                     { 0.030, { 0.25, -0.04, 0.03 }, { 0., 0.12, 0.02 } },
                     { 0.033, { -0.05, 0.01, 0.005 }, { 0., -0.02, 0.01 } } });
}

TEST(RingStack, ResultantsRotationMirrorImageAndTruncationOfSeveralRingsAreCorrect)
{
  const RingStack load = three_rings();
  EXPECT_NEAR(load.normal_force(), 2 * pi * 0.5, ulps(2, pi));
  EXPECT_NEAR(load.a(2), 0.055, ulps(9, 0.055));
  // Reference: trapezoidal rule, which is exact for this load.
  Eigen::Vector2d moment = Eigen::Vector2d::Zero();
  for (const RingStack::Ring &ring : load.rings())
    for (int i = 0; i < 12; ++i)
    {
      const double theta = 2 * pi * i / 12;
      double density = ring.a[0];
      for (unsigned int n = 1; n <= 2; ++n)
        density += ring.a[n] * std::cos(n * theta) + ring.b[n] * std::sin(n * theta);
      moment += density * 2 * pi / 12 * ring.radius * Eigen::Vector2d(std::sin(theta), -std::cos(theta));
    }
  EXPECT_NEAR((load.moment() - moment).norm(), 0., ulps(4, load.moment().norm()));
  const RingStack one({ load.a(0), load.a(1), load.a(2) }, { 0., load.b(1), load.b(2) }, load.radius());
  EXPECT_NEAR(one.moment().norm(), load.moment().norm(), ulps(4, load.moment().norm()));
  EXPECT_NEAR(load.rotated(0.4)(1.4), load(1.), ulps(2, load.normal_force()));
  EXPECT_NEAR(test::mirrored(load)(-1.), load(1.), ulps(2, load.normal_force()));
  EXPECT_EQ(load.truncated(1).rings().size(), 3u);
}

TEST(Sample, IsRestoredExactlyFromItsCoefficients)
{
  const Sample load(three_rings(), { 0.01, -0.02 });
  const Eigen::VectorXd row = load.coefficients(2);
  ASSERT_EQ(row.size(), 23);
  EXPECT_EQ(row(1), -0.02);
  EXPECT_EQ(row(9), 0.030);
  EXPECT_EQ(row(14), 0.12); // coefficient b_1 of the second ring
  const Sample again = Sample::from_coefficients(row, 3);
  EXPECT_EQ(again.coefficients(2), row);
  EXPECT_EQ(again.difference(load), 0.);
  Eigen::VectorXd other = row;
  other(14) += 0.02;
  EXPECT_NEAR(Sample::from_coefficients(other, 3).b(1) - load.b(1), 0.02, ulps(4, 0.14));
  EXPECT_GT(Sample::from_coefficients(other, 3).difference(load), 0.02 / 0.5 - ulps(5, 1));
  const Sample padded = Sample::from_coefficients(load.coefficients(5), 3);
  EXPECT_EQ(padded.n_harmonics(), 5u);
  EXPECT_EQ(padded.difference(load), 0.);
  EXPECT_EQ(load.coefficients(1), Sample(load.truncated(1)).coefficients(1));
}

TEST(RingStack, DifferenceCoversEveryCoefficientAndTheRadius)
{
  const RingStack load({ 0.5, 0.1, 0.02 }, { 0, 0.2, 0.03 }, 0.03);
  EXPECT_EQ(load.difference(load), 0);
  EXPECT_NEAR(RingStack({ 0.5, 0.1, 0.03 }, { 0, 0.2, 0.03 }, 0.03).difference(load), 0.02, ulps(5, 1));
  EXPECT_NEAR(RingStack({ 0.5, 0.1, 0.02 }, { 0, 0.2, 0.02 }, 0.03).difference(load), 0.02, ulps(5, 1));
  EXPECT_NEAR(RingStack({ 0.5, 0.1, 0.02 }, { 0, 0.2, 0.03 }, 1.01 * 0.03).difference(load), 0.01,
              ulps(5, 1));
  EXPECT_NEAR(RingStack({ 0.5, 0.1 }, { 0, 0.2 }, 0.03).difference(load), 0.06, ulps(5, 1));
}

TEST(RingStack, RefusesInvalidCoefficientsRadiiAndResultants)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  using Row = std::vector<double>;
  for (const auto &[a, b, radius] : { std::tuple<Row, Row, double>{ { 1., nan }, { 0., 0. }, 0.03 },
                                      { { -2., 0. }, { 0., 0. }, 0.03 },
                                      { { 0. }, { 0. }, 0.03 },
                                      { { 1. }, { 0. }, -0.03 },
                                      { { 1., 2. }, { 0. }, 0.03 },
                                      { { 1. }, { 0.5 }, 0.03 },
                                      { {}, {}, 0.03 } })
    EXPECT_THROW(RingStack(a, b, radius), std::invalid_argument) << testing::PrintToString(a) << radius;
  EXPECT_THROW(RingStack(std::vector<RingStack::Ring>{}), std::invalid_argument);
  EXPECT_THROW(RingStack({ { 0.03, { 1. }, { 0. } }, { 0.04, { 1., 0. }, { 0., 0. } } }),
               std::invalid_argument);
  EXPECT_THROW(RingStack::first_harmonic(1., { nan, 0. }, 0.03), std::invalid_argument);
  EXPECT_THROW(RingStack::first_harmonic(-1., { 0., 0. }, 0.03), std::invalid_argument);
}

TEST(LoadFunctional, IsLinearAndRotatesWithTheLoad)
{
  test::Numbers numbers(7);
  std::vector<RingStack::Ring> rings;
  for (const double radius : { 0.028, 0.032 })
    rings.push_back(numbers.nonnegative_load(5, radius).rings().front());
  const auto random_functional = [&]
  {
    const auto random = [&] { return numbers.between(-1., 1.); };
    LoadFunctional functional = { Eigen::ArrayXXd::NullaryExpr(6, 2, random),
                                  Eigen::ArrayXXd::NullaryExpr(6, 2, random) };
    functional.b.row(0) = 0.;
    return functional;
  };
  const RingStack load(rings);
  const LoadFunctional one = random_functional(), other = random_functional();
  const double scale = load.normal_force();
  for (const double angle : { -0.4, 0.7, 2.5 })
    EXPECT_NEAR(one.of_rotated(angle)(load), one(load.rotated(angle)), 1e-14 * scale) << angle;
  EXPECT_NEAR((2.5 * one + other)(load), 2.5 * one(load) + other(load), 1e-14 * scale);
}
} // namespace
} // namespace stemware::ring
