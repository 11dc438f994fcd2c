#include "fem/pipeline/coupling/study_load.h"
#include "ring_model/failures.h"
#include "ring_model/friction_functionals.h"
#include "ring_model/load/constants.h"
#include "ring_model/spin/phase_loads.h"
#include "tests/ring_model/quadrature.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{

using namespace stemware::ring;
using stemware::pipeline::parse_waviness;
using stemware::pipeline::Waviness;
using stemware::pipeline::waviness_text;
namespace ring = stemware::ring;

constexpr double two_pi = 2 * ring::pi;

/// Returns an arbitrary load that depends smoothly on both phases and the spin.
ring::RingStack made_up_load(double omega, const ring::Orientation &phase)
{
  const double wave = std::exp(0.3 * std::cos(3 * phase.glass + 0.4)) / (1.5 + std::sin(2 * phase.table));
  return ring::RingStack({ 1., 0.3 + 0.1 * std::cos(omega / 5) * wave, 0.2 * wave },
                         { 0., 0.1 * wave / (1 + omega * omega / 50), -0.05 * wave * wave },
                         0.03 * (1 + 1e-3 * wave));
}

/// Returns tau_z / (mu N R) at a slip ratio, by the trapezoidal rule.
double torque(const ring::RingStack &load, double eps)
{
  return ring::test::wrench_by_quadrature(1, load, eps, load.radius(), 4096).torque /
         (load.normal_force() * load.radius());
}

} // namespace

TEST(Waviness, IsWrittenAndReadBackExactly)
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

TEST(Waviness, RefusesInvalidTexts)
{
  for (const char *text : { "0: 1e-6", "1: 1e-6", "2", "2:", "2: x", "2: 1e-6 @", "2: 1e-6 @ y", "2.5: 1e-6",
                            "-2: 1e-6", "2: 1e-6,", "2: 1e-6; 3: 1e-6", "2: inf", "2: 1e-6 @ 1 @ 2" })
    EXPECT_FALSE(parse_waviness(text)) << text;
}

TEST(Marks, RotateWithOrbitAndYaw)
{
  // At t = 0, the marks are on the side away from the centre of the orbit: on the right of a
  // counter-clockwise motion, azimuth -pi/2.
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

TEST(Marks, PeriodIsAFullTurnOverTheGreatestCommonDivisorOfTheWaveNumbers)
{
  const auto period = [](const Waviness &glass, const Waviness &table) {
    return stemware::pipeline::phase_periods({ glass, table });
  };
  EXPECT_DOUBLE_EQ(period({ { 4, 1e-6, 0 }, { 6, 1e-6, 0 } }, {}).glass, two_pi / 2);
  EXPECT_DOUBLE_EQ(period({ { 3, 1e-6, 0 } }, { { 2, 1e-6, 0 }, { 3, 1e-6, 0 } }).table, two_pi);
  EXPECT_FALSE(period({}, {}).any());
}

namespace
{

const PhasePeriods periods = { two_pi / 3, two_pi / 2 };

} // namespace

TEST(PhaseSampledLoad, InterpolatesWithinTwiceTheStatedError)
{
  const PhaseSamples at_rest = sample_phases(made_up_load, periods, 1024);
  EXPECT_LE(at_rest.error().mean, 1e-5);
  EXPECT_LE(at_rest.error().between, 1e-3);
  EXPECT_GT(at_rest.phases().glass.size(), 4u);
  const PhaseSampledLoad loads(made_up_load, periods, at_rest, { 3. });
  double off = 0;
  for (const double omega : { -10., -4.4, 0., 0.3, 7.7 })
    for (const ring::Orientation &phase : { ring::Orientation{ 0.1, 3.3 }, ring::Orientation{ -12.2, 0.5 } })
      for (const double eps : { -0.5, 0., 0.5 })
        off = std::max(
          off, std::abs(torque(loads.at(omega, phase), eps) - torque(made_up_load(omega, phase), eps)));
  EXPECT_LE(off, 2 * loads.error().between);
  EXPECT_LE(loads.error().between, 1e-3);
  // Rest and at least three spins in each of four intervals are sampled; one interval needs more spins.
  EXPECT_GT(loads.n_spins(), 1u + 4u * 3u);
}

TEST(PhaseSampledLoad, MeanAgreesWithQuadrature)
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
  const PhaseSampledLoad loads(made_up_load, periods, sample_phases(made_up_load, periods, 1024), { 3. });
  const ring::RingStack mean = loads.mean(1.7);
  for (unsigned int k = 0; k <= 2; ++k)
  {
    EXPECT_NEAR(mean.a(k), a[k], 5e-6);
    EXPECT_NEAR(mean.b(k), b[k], 5e-6);
  }
  EXPECT_NEAR(mean.moment().norm(), moment.norm(), 1e-7);
  EXPECT_LE(loads.error().mean, 1e-4);
}

namespace
{

/// Returns a load with b_1 = @p jump for about half of the phases and b_1 = 0 for all other phases.
LoadAtPhase jumping_load(double jump)
{
  return [jump](double, const ring::Orientation &phase) {
    return ring::RingStack({ 1., 0.1 }, { 0., std::sin(2 * phase.glass) > 0.1 ? jump : 0. }, 0.03);
  };
}

} // namespace

// At a jump, the error of the mean is proportional to the spacing of the phases. Reference: exact fraction of
// the phases with b_1 = jump.
TEST(PhaseSampledLoad, MeanOfAJumpingLoadIsWithinTheStatedError)
{
  const double jump = 0.1, share = 0.5 - std::asin(0.1) / ring::pi;
  const PhasePeriods of_glass = { two_pi / 2, 0 };
  const PhaseSampledLoad loads(jumping_load(jump), of_glass,
                               sample_phases(jumping_load(jump), of_glass, 128));
  EXPECT_GT(loads.error().between, 0.2 * jump);
  const ring::RingStack truth({ 1., 0.1 }, { 0., share * jump }, 0.03);
  const double off = torque_difference(loads.mean(0), truth);
  EXPECT_LE(off, loads.error().mean);
  EXPECT_LT(loads.error().mean, 0.05 * jump);
}

// The load has a kink as a function of the spin, which polynomials do not resolve. The interpolation error of
// the mean over the phases is as large as the interpolation error at each phase. Reference: the load at phase
// 0, which equals the exact mean.
TEST(PhaseSampledLoad, ErrorOfTheMeanIncludesInterpolationInTheSpin)
{
  const auto kinked = [](double omega, double phase)
  {
    return ring::RingStack({ 1., 0.1 }, { 0., 0.1 * std::abs(omega - 1.3) + 0.01 * std::sin(2 * phase) },
                           0.03);
  };
  const LoadAtPhase load = [=](double omega, const ring::Orientation &phase)
  { return kinked(omega, phase.glass); };
  const PhasePeriods of_glass = { two_pi / 2, 0 };
  const PhaseSampledLoad loads(load, of_glass, sample_phases(load, of_glass, 128), { 3. });
  double off = 0;
  for (const double omega : { 0.9, 1.2, 1.28, 1.32, 1.5, 2.2 })
    off = std::max(off, torque_difference(loads.mean(omega), kinked(omega, 0)));
  EXPECT_GT(off, 1e-4);
  EXPECT_LE(off, 2 * loads.error().mean);
  EXPECT_LE(loads.error().mean, 1e-2);
}

TEST(PhaseSampledLoad, RefusesMoreIntervalsThanAllowed)
{
  const PhasePeriods of_glass = { two_pi / 2, 0 };
  const PhaseSamples at_rest = sample_phases(jumping_load(0.1), of_glass, 16);
  const PhaseSampledLoad loads(jumping_load(0.1), of_glass, at_rest, { 3., 17, 2 });
  for (const double omega : { -1., 2., -2. })
    EXPECT_NO_THROW(loads.mean(omega)) << omega;
  EXPECT_THROW(loads.mean(4.), ring::NoBalance);
  EXPECT_NO_THROW(loads.mean(1.));
}

TEST(PhaseSampledLoad, RefusesAnUnresolvedJump)
{
  EXPECT_THROW(sample_phases(jumping_load(2.), { two_pi / 2, 0 }, { 128 }), ring::NoBalance);
}
