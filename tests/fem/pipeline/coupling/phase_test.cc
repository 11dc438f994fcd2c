// A load that depends on where the marks of glass and table stand: entries, interpolation, and the spin that
// follows.
#include "fem/pipeline/coupling/phase_loads.h"

#include <boost/math/constants/constants.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace
{

using namespace stemware::pipeline;
namespace ring = stemware::ring;

constexpr double two_pi = boost::math::double_constants::two_pi;

/// A load of made-up smooth dependence on both phases and the spin.
ring::RingStack made_up_load(double omega, const ring::Orientation &phase)
{
  const double wave = std::exp(0.3 * std::cos(3 * phase.glass + 0.4)) / (1.5 + std::sin(2 * phase.table));
  return ring::RingStack({ 1., 0.3 + 0.1 * std::cos(omega / 5) * wave, 0.2 * wave },
                         { 0., 0.1 * wave / (1 + omega * omega / 50), -0.05 * wave * wave },
                         0.03 * (1 + 1e-3 * wave));
}

double difference(const ring::RingStack &one, const ring::RingStack &other)
{
  double largest = std::abs(one.radius() / other.radius() - 1);
  for (unsigned int n = 0; n <= one.n_harmonics(); ++n)
    largest = std::max({ largest, std::abs(one.a(n) - other.a(n)), std::abs(one.b(n) - other.b(n)) });
  return largest;
}

} // namespace

TEST(Waviness, IsReadAndWrittenWithAllDigits)
{
  const auto waviness = parse_waviness(" 2 : 5e-6 @ 0.3,3:-2.000000000000001e-6 ");
  ASSERT_TRUE(waviness);
  ASSERT_EQ(waviness->size(), 2u);
  EXPECT_EQ(waviness->at(0).n, 2u);
  EXPECT_EQ(waviness->at(0).amplitude, 5e-6);
  EXPECT_EQ(waviness->at(0).azimuth, 0.3);
  EXPECT_EQ(waviness->at(1).amplitude, -2.000000000000001e-6);
  EXPECT_EQ(waviness->at(1).azimuth, 0);
  EXPECT_EQ(waviness_text(*waviness), "2: 5e-6 @ 0.3, 3: -2.000000000000001e-6");
  EXPECT_EQ(waviness_text(*parse_waviness(waviness_text(*waviness))), waviness_text(*waviness));
  EXPECT_TRUE(parse_waviness("")->empty());
  EXPECT_EQ(waviness_text({}), "");
}

TEST(Waviness, TakesNothingElse)
{
  for (const char *text : { "0: 1e-6", "1: 1e-6", "2", "2:", "2: x", "2: 1e-6 @", "2: 1e-6 @ y", "2.5: 1e-6",
                            "-2: 1e-6", "2: 1e-6,", "2: 1e-6; 3: 1e-6", "2: inf", "2: 1e-6 @ 1 @ 2" })
    EXPECT_FALSE(parse_waviness(text)) << text;
}

TEST(Waviness, HasItsCrestsWhereItSays)
{
  const stemware::fem::RimImperfection rim = { { { 3, 2e-6, 0.4 } }, {} };
  for (const unsigned int crest : { 0u, 1u, 2u })
  {
    EXPECT_NEAR(rim.gap(1, 0.4 + two_pi * crest / 3, {}), 2e-6, 1e-20);
    EXPECT_NEAR(rim.gap(1, 0.4 + two_pi * (crest + 0.5) / 3, {}), -2e-6, 1e-20);
  }
}

TEST(Marks, StandWhereTheOrbitAndTheYawPutThem)
{
  // At t = 0 azimuth 0 points away from the orbit's centre: to the right of a counter-clockwise motion.
  ring::Motion motion;
  const double orbit = motion.orbit_speed / motion.orbit_radius;
  const ring::Orientation start = orientation_of_marks(motion, 0, 0);
  EXPECT_DOUBLE_EQ(start.glass, -two_pi / 4);
  EXPECT_DOUBLE_EQ(start.table, -two_pi / 4);
  const ring::Orientation later = orientation_of_marks(motion, 0.7, -1.1);
  EXPECT_DOUBLE_EQ(later.glass, -1.1 - orbit * 0.7 - two_pi / 4);
  EXPECT_DOUBLE_EQ(later.table, -orbit * 0.7 - two_pi / 4);
  motion.orbit_sense = ring::OrbitSense::clockwise;
  const ring::Orientation mirrored = orientation_of_marks(motion, 0.7, 1.1);
  EXPECT_DOUBLE_EQ(mirrored.glass, -later.glass);
  EXPECT_DOUBLE_EQ(mirrored.table, -later.table);
}

TEST(Marks, RepeatWithTheCommonDivisorOfTheHarmonics)
{
  const auto period = [](const Waviness &glass, const Waviness &table) {
    return phase_periods({ glass, table });
  };
  EXPECT_DOUBLE_EQ(period({ { 4, 1e-6, 0 }, { 6, 1e-6, 0 } }, {}).glass, two_pi / 2);
  EXPECT_DOUBLE_EQ(period({ { 3, 1e-6, 0 } }, { { 2, 1e-6, 0 }, { 3, 1e-6, 0 } }).table, two_pi);
  EXPECT_FALSE(period({}, {}).any());
}

TEST(PeriodicGrid, IsExactForTrigonometricPolynomials)
{
  const double period = two_pi / 3;
  const PeriodicGrid grid(period, 8);
  const auto value = [](double angle) { return 1 + std::cos(3 * angle + 0.3) - 0.7 * std::sin(9 * angle); };
  Eigen::VectorXd nodes(8);
  for (unsigned int i = 0; i < 8; ++i)
    nodes(i) = value(grid.node(i));
  for (const double angle : { 0., 0.1, period / 8, -5.7, 40. })
    EXPECT_NEAR(grid.weights(angle).dot(nodes), value(angle), 1e-12) << angle;
}

TEST(SpinInterval, IsExactForPolynomials)
{
  const SpinInterval interval(-3, 1, 4);
  ASSERT_EQ(interval.size(), 5u);
  const auto value = [](double x) { return 1 + x - 0.3 * x * x * x * x; };
  Eigen::VectorXd nodes(5);
  for (unsigned int k = 0; k < 5; ++k)
    nodes(k) = value(interval.node(k));
  for (const double x : { -3., -2.2, -1., 0.3, 1. })
    EXPECT_NEAR(interval.weights(x).dot(nodes), value(x), 1e-12) << x;
  const SpinInterval refined = interval.refined();
  ASSERT_EQ(refined.size(), 9u);
  for (unsigned int k = 0; k < 4; ++k)
    EXPECT_DOUBLE_EQ(refined.node(2 * k + 1), interval.between()[k]);
}

TEST(PhaseLoads, InterpolateWithinTheStatedError)
{
  const PhaseGrids grids = find_phases(made_up_load, { two_pi / 3, two_pi / 2 }, 1024);
  EXPECT_LE(grids.error, 1e-6);
  EXPECT_GT(grids.glass.size(), 8u);
  const PhaseLoads loads(made_up_load, grids, 3.);
  for (const double omega : { -10., -4.4, 0., 0.3, 7.7 })
    for (const ring::Orientation &phase : { ring::Orientation{ 0.1, 3.3 }, ring::Orientation{ -12.2, 0.5 } })
      EXPECT_LT(difference(loads.at(omega, phase).rings, made_up_load(omega, phase)), 2 * loads.error())
        << omega;
  EXPECT_LE(loads.error(), 1e-6);
  EXPECT_GT(loads.n_spins(), 4u * 5u);
}

TEST(PhaseLoads, HaveTheMeanOfPlainQuadrature)
{
  std::vector<double> a(3, 0.), b(3, 0.);
  Eigen::Vector2d moment = Eigen::Vector2d::Zero();
  constexpr unsigned int n = 60;
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < n; ++j)
    {
      const ring::RingStack load = made_up_load(1.7, { two_pi * i / n, two_pi * j / n });
      moment += load.moment() / (n * n);
      for (unsigned int k = 0; k <= 2; ++k)
      {
        a[k] += load.a(k) / (n * n);
        b[k] += load.b(k) / (n * n);
      }
    }
  // Half the phases that the loads themselves need do for the mean.
  const PhaseGrids grids = find_phases(made_up_load, { two_pi / 3, two_pi / 2 }, 1024);
  for (const PhaseGrids &sampled : { grids, grids.halved() })
  {
    const ring::RingStack mean = PhaseLoads(made_up_load, sampled, 3.).mean(1.7).rings;
    for (unsigned int k = 0; k <= 2; ++k)
    {
      EXPECT_NEAR(mean.a(k), a[k], 2 * grids.error);
      EXPECT_NEAR(mean.b(k), b[k], 2 * grids.error);
    }
    EXPECT_NEAR(mean.moment().norm(), moment.norm(), 1e-8);
  }
}

TEST(PhaseLoads, SayThatAJumpIsNotResolved)
{
  const auto jump = [](double, const ring::Orientation &phase) {
    return ring::RingStack({ 1., 0.1, std::sin(2 * phase.glass) > 0.1 ? 0.1 : 0. }, { 0., 0., 0. }, 0.03);
  };
  EXPECT_THROW(find_phases(jump, { two_pi / 2, 0 }), std::runtime_error);
}
