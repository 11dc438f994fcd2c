// Loads in balance with friction at every spin: balances from their neighbours, curves between samples.
#include "ring_model/spin/load.h"
#include "ring_model/spin/spin_curve.h"
#include "tests/ring_model/unilateral_rim.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace stemware::pipeline
{
namespace
{

constexpr double weight = 2.943; // N
constexpr double rim = 0.03;     // m

/// Loads of the rim over the moment ratio.
ring::RingStack rim_load(double moment_ratio)
{
  return ring::test::UnilateralFoundation(rim, 1.5).rings(weight, { 0, -moment_ratio * weight * rim / 2 });
}

/// Moment ratio at which the pressure, which goes like the power 3/2 of the penetration, vanishes at one
/// place: with lambda ~ cos^3(theta / 2), 2 integral lambda cos theta / integral lambda.
constexpr double lift_off = 1.2;

ring::CurveTolerance to(double wanted)
{
  ring::CurveTolerance tolerance;
  tolerance.wanted = tolerance.enough = tolerance.coarsest = wanted;
  tolerance.max_samples = 1000;
  return tolerance;
}

TEST(SpinCurve, StatesAnErrorThatHolds)
{
  // The curve that does not know where the rim lifts off takes more pieces; the kink stays between nodes.
  const ring::CurveSource blind = { rim_load };
  const auto with_margin = [](double m)
  {
    ring::Sample load = rim_load(m);
    load.lift_off_margin = lift_off - m;
    return load;
  };
  const ring::CurveSource seeing = { with_margin };
  for (const auto &[source, bounds] : { std::pair(blind, 3.), std::pair(seeing, 1.) })
    for (const double upper : { 1.1, 1.5 })
      for (const double tolerance : { 1e-4, 1e-7 })
      {
        const ring::SpinCurve curve(source, 0, upper, to(tolerance));
        EXPECT_LE(curve.error(), tolerance);
        EXPECT_GT(curve.error(), 0);
        for (unsigned int i = 0; i <= 501; ++i)
        {
          const double m = upper * i / 501;
          EXPECT_LE(curve(m).difference(rim_load(m)), bounds * curve.error()) << m;
        }
      }
}

TEST(SpinCurve, TellsALoadByItsDifferenceToALikeOne)
{
  // Beside a load that differs by a thousandth, which is itself not smooth in the place of the other.
  const ring::LoadFunction like = [](double m) { return rim_load(m); };
  const ring::LoadFunction load = [](double m)
  {
    const Eigen::VectorXd row = ring::Sample(rim_load(m)).coefficients(24);
    return ring::Sample::from_coefficients((1 + 1e-3 * m * m) * row, 1);
  };
  ring::CurveSource source = { load };
  const ring::SpinCurve alone(source, 0, 1.1, to(1e-6));
  source.reference = like;
  const ring::SpinCurve beside(source, 0, 1.1, to(1e-6));
  EXPECT_LT(beside.n_samples(), alone.n_samples());
  for (unsigned int i = 0; i <= 200; ++i)
    EXPECT_LE(beside(1.1 * i / 200).difference(load(1.1 * i / 200)), beside.error()) << i;
}

TEST(SpinCurve, FindsWhereTheRimLiftsOff)
{
  // As many harmonics as a contact gives to a ring: high ones turn with the edges of the contact.
  const ring::test::UnilateralFoundation rim_of_24(rim, 1.5, 24);
  const auto load = [&](double m) -> ring::Sample {
    return rim_of_24.rings(weight, { 0, -m * weight * rim / 2 });
  };
  const auto with_margin = [&](double m)
  {
    ring::Sample sample = load(m);
    sample.lift_off_margin = (lift_off - m) * (1 + m);
    return sample;
  };
  for (const double upper : { 1.3, 1.5 })
  {
    const ring::SpinCurve curve({ with_margin }, 0, upper, to(1e-6));
    ASSERT_EQ(curve.lift_offs().size(), 1u);
    EXPECT_NEAR(curve.lift_offs().front(), lift_off, 1e-5 * upper);
    EXPECT_LT(3 * curve.n_samples(), 2 * ring::SpinCurve({ load }, 0, upper, to(1e-6)).n_samples());
  }
}

TEST(SpinCurve, SaysWhenSamplesDoNotSuffice)
{
  ring::CurveTolerance tolerance = to(1e-12);
  tolerance.max_samples = 60;
  const ring::SpinCurve curve({ rim_load }, 0, 1.5, tolerance);
  EXPECT_GT(curve.error(), 1e-12);
  EXPECT_LT(curve.n_samples(), 100u);
}

// The load of a rigid round rim, stated to be costly.
TEST(Load, InterpolatesWithinTheErrorThatItStates)
{
  const ring::test::BalancedRim glass{ ring::Closure::full, ring::Motion(),
                                       ring::test::UnilateralFoundation(rim, 1.5) };
  const auto exact = [&](double omega) -> ring::Sample { return glass.at(omega).load; };
  const ring::Load curve = ring::Load::solved_once(exact, exact(0)).interpolated(-4, 0.5);
  const double stated = curve.interpolation_error().value();
  EXPECT_LE(stated, 1e-6);
  for (double omega = -3.97; omega < 0.5; omega += 0.13)
    EXPECT_LE(curve.at(omega).difference(exact(omega)), stated) << omega;
  EXPECT_EQ(curve.at(2.5).difference(exact(2.5)), 0); // beyond the samples
}

} // namespace
} // namespace stemware::pipeline
