#include "fem/pipeline/analysis/closure_comparison.h"
#include "fem/pipeline/analysis/yaw_study.h"

#include <gtest/gtest.h>

#include <cmath>

namespace stemware::pipeline
{
namespace
{

/// A frozen load with harmonics up to 9, all of which matter.
LoadAtSpin rich_load()
{
  const ring::RingStack load({ 0.47, 0.1, 0.09, 0, -0.02, 0, 0.004, 0, -0.001, 0 },
                               { 0, -0.3, 0, 0.04, 0, 0.01, 0, -0.003, 0, 0.001 }, 0.03);
  return [load](double) { return load; };
}

TEST(YawStudy, TruncationsEndWithAllHarmonics)
{
  const YawStudy study = study_yaw(rich_load(), ring::Motion());
  std::vector<unsigned int> orders;
  for (const TruncationRow &row : study.truncations)
    orders.push_back(row.harmonics);
  EXPECT_EQ(orders, (std::vector<unsigned int>{ 1, 2, 3, 4, 6, 8, 9 }));
  const TruncationRow &all = study.truncations.back();
  EXPECT_EQ(all.omega_terminal, study.terminal.omega);
  EXPECT_EQ(all.relative_change, 0.);
  EXPECT_EQ(all.bound, 0);
}

TEST(YawStudy, TerminalSpinIsFreeOfTorque)
{
  const ring::Motion motion;
  const YawStudy study = study_yaw(rich_load(), motion);
  const double scale = motion.friction_coefficient * rich_load()(0).normal_force() * 0.03;
  EXPECT_LT(std::abs(study.at_terminal.torque), 1e-13 * scale);
  EXPECT_TRUE(study.terminal.stable);
  EXPECT_NEAR(*study.time_constant * std::abs(study.terminal.torque_slope), motion.yaw_inertia, 1e-16);
}

TEST(YawStudy, BoundHoldsForEveryTruncation)
{
  const ring::Motion motion;
  const ring::CoulombRing friction(motion.friction_coefficient);
  const ring::RingStack load = rich_load()(0);
  const YawStudy study = study_yaw(rich_load(), motion);
  const double omega = study.terminal.omega;
  for (const TruncationRow &row : study.truncations)
  {
    const double change = friction.wrench(load.truncated(row.harmonics), omega, motion.orbit_speed).torque -
                          friction.wrench(load, omega, motion.orbit_speed).torque;
    EXPECT_LE(std::abs(change), row.bound + 1e-16) << row.harmonics;
  }
  EXPECT_GT(study.truncations.front().bound, 0);
}

TEST(YawStudy, WithoutAMomentThereIsNoSpinToRelateTo)
{
  const ring::RingStack even({ 0.47, 0, 0.05 }, { 0, 0, 0 }, 0.03);
  const YawStudy study = study_yaw([even](double) { return even; }, ring::Motion());
  EXPECT_EQ(study.terminal.omega, 0);
  for (const TruncationRow &row : study.truncations)
    EXPECT_FALSE(row.relative_change) << row.harmonics;
}

TEST(YawStudy, TorqueCurvePassesThroughRestAndTerminalSpin)
{
  const ring::Motion motion;
  const YawStudy study = study_yaw(rich_load(), motion);
  const TorqueCurve curve = torque_curve(rich_load(), motion);
  const std::size_t rest = curve.omega.size() / 2;
  EXPECT_EQ(curve.omega[rest], 0);
  EXPECT_EQ(curve.friction[rest].torque, study.at_rest.torque);
  for (std::size_t i = 1; i < curve.omega.size(); ++i)
  {
    const bool encloses_terminal =
      (curve.omega[i - 1] < study.terminal.omega) != (curve.omega[i] < study.terminal.omega);
    EXPECT_EQ(curve.friction[i - 1].torque * curve.friction[i].torque < 0, encloses_terminal) << i;
  }
  EXPECT_EQ(curve.truncations.size(), 6u);
  EXPECT_NE(curve.truncations.front(), curve.truncations.back());
}

TEST(YawStudy, EulerConvergesAtFirstOrderToTheAdaptiveSpinUp)
{
  MotionSection motion;
  motion.end_time = 0.5;
  const auto error = [&](double step)
  {
    motion.euler_step = step;
    const SpinUpCurves curves = spin_up_curves(rich_load(), motion);
    double largest = 0;
    for (std::size_t i = 0; i < curves.time.size(); ++i)
      largest = std::max(largest, std::abs(curves.euler[i] - curves.adaptive[i]));
    return largest;
  };
  EXPECT_NEAR(error(5e-4) / error(2.5e-4), 2, 0.05);
  EXPECT_NEAR(error(2.5e-4) / error(1.25e-4), 2, 0.03);
}

TEST(ClosureComparison, ReproducesTheTableOfClosures)
{
  ring::Motion motion;
  motion.centre_of_mass_height = 0.06;
  const std::vector<ClosureRow> rows = compare_closures(motion, 0.03);
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_NEAR(*rows[0].omega_terminal, -3.12055870152586, 1e-12);
  EXPECT_NEAR(*rows[1].omega_terminal, -5.03205140582681, 1e-12);
  EXPECT_NEAR(*rows[2].omega_terminal, -3.17573357712208, 1e-12);
  EXPECT_FALSE(rows[0].is_formal());
  EXPECT_TRUE(rows[1].is_formal());
  EXPECT_FALSE(rows[2].is_formal());
  EXPECT_NEAR(rows[1].moment_ratio_at_rest, 1.037787677770, 1e-12);
  EXPECT_NEAR(*rows[1].moment_ratio_at_terminal, 1.059989467677, 1e-12);
}

} // namespace
} // namespace stemware::pipeline
