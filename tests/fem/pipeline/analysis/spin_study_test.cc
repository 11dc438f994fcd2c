#include "fem/pipeline/analysis/spin.h"
#include "fem/pipeline/analysis/spin_study.h"
#include "ring_model/unilateral_foundation.h"

#include <gtest/gtest.h>

#include <cmath>

namespace stemware::pipeline
{
namespace
{

/// A load with harmonics up to 9, all of which matter.
ring::RingStack rich_load()
{
  return { { 0.47, 0.1, 0.09, 0, -0.02, 0, 0.004, 0, -0.001, 0 },
           { 0, -0.3, 0, 0.04, 0, 0.01, 0, -0.003, 0, 0.001 },
           0.03 };
}

BalancedLoad constant(const ring::RingStack &load)
{
  return BalancedLoad({ report_of(load), {} });
}

Study quick_study()
{
  Study study;
  study.motion.end_time = 0.5;
  return study;
}

TEST(SpinStudy, TruncationsEndWithAllHarmonics)
{
  const SpinStudy study = study_spin(constant(rich_load()), quick_study());
  std::vector<unsigned int> orders;
  for (const SpinRow &row : study.rows)
    orders.push_back(row.harmonics);
  EXPECT_EQ(orders, (std::vector<unsigned int>{ 1, 2, 3, 4, 6, 8, 9 }));
  EXPECT_TRUE(study.all().all_harmonics);
  EXPECT_EQ(study.all().relative_change, 0.);
  EXPECT_EQ(study.all().bound, 0.);
}

TEST(SpinStudy, TerminalSpinIsFreeOfTorque)
{
  const ring::Motion motion;
  const SpinRow row = study_spin(constant(rich_load()), quick_study()).all();
  const double scale = motion.friction_coefficient * rich_load().normal_force() * 0.03;
  EXPECT_LT(std::abs(row.at_terminal->friction.torque), 1e-13 * scale);
  EXPECT_TRUE(row.terminal->stable);
  EXPECT_NEAR(*row.time_constant() * std::abs(row.terminal->torque_slope), motion.yaw_inertia, 1e-16);
}

TEST(SpinStudy, BoundHoldsForEveryTruncation)
{
  const ring::Motion motion;
  const ring::CoulombRing friction(motion.friction_coefficient);
  const ring::RingStack load = rich_load();
  const SpinStudy study = study_spin(constant(load), quick_study());
  const double omega = study.all().terminal->omega;
  for (const SpinRow &row : study.rows)
  {
    const double change = friction.wrench(load.truncated(row.harmonics), omega, motion.orbit_speed).torque -
                          friction.wrench(load, omega, motion.orbit_speed).torque;
    EXPECT_LE(std::abs(change), *row.bound + 1e-16) << row.harmonics;
  }
  EXPECT_GT(*study.rows.front().bound, 0);
}

TEST(SpinStudy, WithoutAMomentThereIsNoSpinToRelateTo)
{
  const SpinStudy study = study_spin(constant({ { 0.47, 0, 0.05 }, { 0, 0, 0 }, 0.03 }), quick_study());
  EXPECT_EQ(study.all().terminal->omega, 0);
  EXPECT_FALSE(study.spins_up());
  for (const SpinRow &row : study.rows)
    EXPECT_FALSE(row.relative_change) << row.harmonics;
}

TEST(SpinStudy, TorqueCurvePassesThroughRestAndTerminalSpin)
{
  const SpinStudy study = study_spin(constant(rich_load()), quick_study());
  const TorqueCurve &curve = study.torque;
  const double terminal = study.all().terminal->omega;
  const std::size_t rest = curve.omega.size() / 2;
  EXPECT_EQ(curve.omega[rest], 0);
  EXPECT_EQ(curve.friction[rest].torque, study.all().at_rest->friction.torque);
  for (std::size_t i = 1; i < curve.omega.size(); ++i)
  {
    const bool encloses_terminal = (curve.omega[i - 1] < terminal) != (curve.omega[i] < terminal);
    EXPECT_EQ(curve.friction[i - 1].torque * curve.friction[i].torque < 0, encloses_terminal) << i;
  }
  EXPECT_EQ(curve.truncations.size(), 6u);
  EXPECT_NE(curve.truncations.front(), curve.truncations.back());
}

TEST(SpinStudy, EulerConvergesAtFirstOrderToTheAdaptiveSpinUp)
{
  Study study = quick_study();
  const auto error = [&](double step)
  {
    study.motion.euler_step = step;
    const SpinUpCurves curves = study_spin(constant(rich_load()), study).spin_up;
    double largest = 0;
    for (std::size_t i = 0; i < curves.time.size(); ++i)
      largest = std::max(largest, std::abs(curves.euler[i] - curves.adaptive[i]));
    return largest;
  };
  EXPECT_NEAR(error(5e-4) / error(2.5e-4), 2, 0.05);
  EXPECT_NEAR(error(2.5e-4) / error(1.25e-4), 2, 0.03);
}

TEST(SpinStudy, EveryCurveIsOfTheLoadThatItIsNamedAfter)
{
  // Each against an integration of its own; the four differ by percents.
  const Study study = quick_study();
  const ring::Motion &motion = study.motion.orbit;
  const SpinUpCurves curves = study_spin(constant(rich_load()), study).spin_up;
  const auto follow = [&](const ring::RingStack &load)
  {
    const ring::CoulombRing friction(motion.friction_coefficient);
    double omega = 0;
    const int n_steps = 4000;
    const double step = study.motion.end_time / n_steps;
    const auto rate = [&](double spin)
    { return friction.wrench(load, spin, motion.orbit_speed).torque / motion.yaw_inertia; };
    for (int i = 0; i < n_steps; ++i) // midpoint rule
      omega += step * rate(omega + step / 2 * rate(omega));
    return omega;
  };
  EXPECT_NEAR(curves.adaptive.back(), follow(rich_load()), 1e-6);
  EXPECT_NEAR(curves.first_harmonic.back(), follow(rich_load().truncated(1)), 1e-6);
  // Without the moment of friction the paper's load is the same at every spin.
  EXPECT_NEAR(curves.paper.back(),
              follow(ring::RingStack::first_harmonic(
                motion.normal_force(), ring::required_moment_at_rest(ring::Closure::paper, motion), 0.03)),
              1e-6);
  EXPECT_GT(std::abs(curves.euler.back() - curves.adaptive.back()),
            1e-6); // the paper's method, not the exact one
  EXPECT_NEAR(curves.euler.back(), curves.adaptive.back(), 1e-2);
}

TEST(SpinStudy, ReproducesTheTableOfClosures)
{
  Study study;
  study.motion.orbit.centre_of_mass_height = 0.06;
  const std::vector<SpinRow> rows = closure_rows(study);
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_NEAR(rows[0].terminal->omega, -3.12055870152586, 1e-12);
  EXPECT_NEAR(rows[1].terminal->omega, -5.03205140582681, 1e-12);
  EXPECT_NEAR(rows[2].terminal->omega, -3.17573357712208, 1e-12);
  EXPECT_FALSE(rows[0].pulls());
  EXPECT_TRUE(rows[1].pulls());
  EXPECT_FALSE(rows[2].pulls());
  EXPECT_NEAR(rows[1].at_rest->moment_ratio, 1.037787677770, 1e-12);
  EXPECT_NEAR(rows[1].at_terminal->moment_ratio, 1.059989467677, 1e-12);
}

TEST(SpinRow, SaysWhyThereIsNone)
{
  // A load model that tips, one without a balance, and a torque that keeps its sign.
  const auto refusing = [](auto failure)
  {
    return BalancedLoad({ report_of(rich_load()),
                          [failure](double omega) -> ring::RingStack
                          {
                            if (omega != 0)
                              throw failure;
                            return rich_load();
                          } });
  };
  const SpinQuestion question = { ring::Motion() };
  const SpinRow tips = attempt_spin_row(refusing(ring::Tipping("it tips")), question);
  EXPECT_EQ(tips.standing, Standing::tips);
  EXPECT_EQ(tips.reason, "it tips");
  EXPECT_TRUE(tips.at_rest);
  EXPECT_FALSE(tips.terminal);
  EXPECT_EQ(attempt_spin_row(refusing(std::runtime_error("none")), question).standing, Standing::no_balance);
  // A first harmonic whose moment grows faster than K_1 falls off, like eps^-3, drives the ring for ever.
  const auto with_ratio = [](double m) {
    return ring::RingStack::first_harmonic(2.943, { m * 2.943 * 0.03 / 2, 0 }, 0.03);
  };
  const auto growing = [=](double omega)
  { return with_ratio(4 + 10 * std::pow(std::abs(omega) * 0.03 / 0.35, 3)); };
  const SpinRow endless = attempt_spin_row(BalancedLoad({ report_of(with_ratio(4)), growing }), question);
  EXPECT_EQ(endless.standing, Standing::no_terminal_spin);
  EXPECT_EQ(attempt_spin_row(constant(with_ratio(1.5)), question).standing, Standing::formal);
  EXPECT_EQ(attempt_spin_row(constant(rich_load()), question).standing, Standing::full_contact);
}

} // namespace
} // namespace stemware::pipeline
