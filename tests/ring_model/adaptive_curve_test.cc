#include "ring_model/spin/adaptive_curve.h"
#include "ring_model/spin/load.h"
#include "tests/ring_model/unilateral_rim.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

namespace stemware
{
namespace
{

constexpr double weight = 2.943; // [N]
constexpr double rim = 0.03;     // [m]

ring::RingStack rim_load(double moment_ratio)
{
  return ring::test::UnilateralFoundation(rim, 1.5).rings(weight, { 0, -moment_ratio * weight * rim / 2 });
}

/// Moment ratio at the onset of lift-off: 2 int lambda cos theta / int lambda for lambda ~ cos^3(theta / 2).
constexpr double lift_off = 1.2;

constexpr unsigned int n_harmonics = 24;

ring::CurveTolerance to(double wanted)
{
  return { wanted, wanted, 20, 1000 };
}

ring::CurveSource rim_source(const std::vector<double> &kinks = {})
{
  const auto load_of = [](const Eigen::VectorXd &row) { return ring::Sample::from_coefficients(row, 1); };
  return { [](double m) { return ring::Sample(rim_load(m)).coefficients(n_harmonics); },
           [=](double, const Eigen::VectorXd &interpolated, const Eigen::VectorXd &exact)
           { return load_of(interpolated).difference(load_of(exact)); },
           {},
           kinks };
}

TEST(AdaptiveCurve, TrueErrorIsAtMostThreeTimesTheStatedError)
{
  // The factor three is allowed only if the kink is not given.
  for (const bool is_known : { false, true })
    for (const double upper : { 1.1, 1.5 })
      for (const double tolerance : { 1e-4, 1e-7 })
      {
        const ring::CurveSource source =
          rim_source(is_known && upper > lift_off ? std::vector<double>{ lift_off } : std::vector<double>());
        const ring::AdaptiveCurve curve(source, 0, upper, to(tolerance));
        EXPECT_LE(curve.error(), tolerance);
        EXPECT_GT(curve.error(), 0);
        for (unsigned int i = 0; i <= 501; ++i)
        {
          const double m = upper * i / 501;
          EXPECT_LE(source.error(m, curve(m), source.value(m)), (is_known ? 1 : 3) * curve.error()) << m;
        }
      }
}

TEST(AdaptiveCurve, TakesFewerSamplesWithAKnownKink)
{
  const ring::AdaptiveCurve with_kink(rim_source({ lift_off }), 0, 1.5, to(1e-6));
  const ring::AdaptiveCurve without(rim_source(), 0, 1.5, to(1e-6));
  EXPECT_LT(3 * with_kink.n_samples(), 2 * without.n_samples());
}

TEST(AdaptiveCurve, ReportsAnErrorAboveTheToleranceIfSamplesRunOut)
{
  ring::CurveTolerance tolerance = to(1e-12);
  tolerance.max_samples = 60;
  const ring::AdaptiveCurve curve(rim_source(), 0, 1.5, tolerance);
  EXPECT_GT(curve.error(), 1e-12);
  EXPECT_LT(curve.n_samples(), 100u);
}

struct Rim
{
  ring::test::BalancedRim glass{ ring::Closure::full, ring::Motion(),
                                 ring::test::UnilateralFoundation(rim, 1.5) };

  ring::Sample at(double omega) const { return glass.at(omega).load; }
};

TEST(Load, InterpolatesWithinTheStatedErrorAndIsExactOutsideTheRange)
{
  const Rim rim_in_balance;
  const auto exact = [&](double omega) { return rim_in_balance.at(omega); };
  const ring::Load curve = ring::Load::solved_once(exact, exact(0)).interpolated(-4, 0.5);
  const double stated = curve.interpolation_error().value();
  EXPECT_LE(stated, 1e-6);
  for (double omega = -3.97; omega < 0.5; omega += 0.13)
    EXPECT_LE(curve.at(omega).difference(exact(omega)), stated) << omega;
  EXPECT_EQ(curve.at(2.5).difference(exact(2.5)), 0);
}

TEST(Load, JumpIncreasesTheStatedErrorAndTakesAtMost80Samples)
{
  unsigned int n_solved = 0;
  const auto jumping = [&](double omega)
  {
    ++n_solved;
    return ring::Sample(rim_load(omega < -1.7 ? 0.7 : 0.5));
  };
  const ring::Load curve = ring::Load::solved_once(jumping, jumping(0)).interpolated(-4, 0.5);
  const double jump = ring::Sample(rim_load(0.7)).difference(rim_load(0.5));
  EXPECT_TRUE(std::isfinite(curve.interpolation_error().value()));
  EXPECT_GT(curve.interpolation_error().value(), jump / 10);
  for (const double omega : { -3.3, -2.1, -1.3, 0.1 })
    EXPECT_LT(curve.at(omega).difference(jumping(omega)), 1e-3 * jump) << omega;
  EXPECT_LE(n_solved, 80 + 3 + 4u); // 80 on the curve, 3 at rest and at both ends, 4 in the loop above
}

TEST(Load, InterpolatesWithFewerSamplesNextToASimilarLoad)
{
  const Rim rim_in_balance;
  const auto exact = [&](double omega) { return rim_in_balance.at(omega); };
  unsigned int n_solved = 0;
  const auto changed = [&](double omega)
  {
    ++n_solved;
    const ring::Sample load = exact(omega);
    const Eigen::VectorXd row = load.coefficients(load.n_harmonics());
    Eigen::VectorXd scaled = (1 + 1e-3 * omega / 4) * row;
    scaled(2) = row(2);
    return ring::Sample::from_coefficients(scaled, 1);
  };
  const ring::Load like = ring::Load::solved_once(exact, exact(0)).interpolated(-4, 0.5);
  const ring::Load alone = ring::Load::solved_once(changed, changed(0)).interpolated(-4, 0.5);
  const unsigned int n_alone = std::exchange(n_solved, 0u);
  const ring::Load beside = ring::Load::solved_once(changed, changed(0)).interpolated(-4, 0.5, {}, &like);
  EXPECT_LT(n_solved, n_alone);
  for (double omega = -3.97; omega < 0.5; omega += 0.13)
    EXPECT_LE(beside.at(omega).difference(changed(omega)), 1e-6) << omega;
}

} // namespace
} // namespace stemware
