#include "ring_model/spin/torque_effect.h"
#include "tests/ring_model/quadrature.h"
#include "tests/ulps.h"

#include <gtest/gtest.h>

#include <cmath>

namespace stemware::ring
{
namespace
{
constexpr double radius = 0.03;

RingStack load_at(double omega)
{
  const double s = 1. + 0.02 * omega;
  return RingStack({ { 0.028, { 0.15, 0.03, 0.02 * s, -0.01, 0.004 }, { 0., 0.1 * s, -0.01, 0.02, 0.003 } },
                     { 0.030, { 0.20, 0.02, -0.01, 0.01 * s, 0.002 }, { 0., 0.12, 0.015, -0.01 * s, 0.001 } },
                     { 0.032, { 0.12, -0.01, 0.03, 0.005, 0.001 }, { 0., 0.07, 0.004, 0.006, -0.002 } } });
}

const Load the_load([](double omega) -> Sample { return load_at(omega); });

/// Returns tau_z [N m] of the load truncated after harmonic @p n, by the trapezoidal rule.
double torque_by_quadrature(double omega, unsigned int n)
{
  const Motion motion;
  return test::wrench_by_quadrature(motion.friction_coefficient, load_at(omega).truncated(n), omega,
                                    motion.orbit_speed, 4000)
    .torque;
}

/// Rounding error of torques of mu N R = 0.03 N m. The quadrature error, (omega R / v)^4000, is negligible.
const double tolerance = ulps(16, 0.03);

TEST(TorqueEffect, AgreesWithQuadratureOfTruncatedLoadsAndStaysBelowItsBound)
{
  const Motion motion;
  const Answer all = answer(the_load, { motion });
  const double omega = *all.omega_terminal();
  const TorqueEffects effects = torque_effects(the_load, motion, all, { 1, 2, 3, 4, 9 }, &the_load);
  EXPECT_NEAR(effects.torque_at_rest, std::abs(torque_by_quadrature(0., 4)), tolerance);
  ASSERT_EQ(effects.rows.size(), 5u);
  for (const TorqueEffect &row : effects.rows)
    for (const auto &[spin, found] : { std::pair(omega / 2, row.half), std::pair(omega, row.terminal) })
    {
      const double cut = torque_by_quadrature(spin, row.harmonics);
      EXPECT_NEAR(found.value().change, cut - torque_by_quadrature(spin, 1), tolerance);
      EXPECT_NEAR(found.value().rest, torque_by_quadrature(spin, 4) - cut, tolerance);
      EXPECT_GE(found.value().bound, std::abs(found.value().rest));
      EXPECT_LT(found.value().bound, row.harmonics < 4 ? 4e-4 : 1e-300);
    }
}

TEST(TorqueEffect, LargestEffectAgreesWithADenseScan)
{
  const Motion motion;
  const Answer all = answer(the_load, { motion });
  const TorqueEffects effects = torque_effects(the_load, motion, all, { 1, 2, 4 }, &the_load);
  EXPECT_EQ(effects.rows[0].largest, 0.);
  for (const TorqueEffect &row : { effects.rows[1], effects.rows[2] })
  {
    double largest = 0.;
    for (int i = 0; i <= 5000; ++i)
    {
      const double omega = *all.omega_terminal() * i / 5000;
      const double change = TorqueByHarmonics(motion, load_at(omega), omega).change(row.harmonics);
      largest = std::abs(change) > std::abs(largest) ? change : largest;
    }
    // The maximum lies between two points of the scan, so the largest value of the scan is too small by up to
    // 1e-8 (relative).
    EXPECT_NEAR(*row.largest, largest, 1e-7 * std::abs(largest));
    EXPECT_NEAR(*row.largest,
                TorqueByHarmonics(motion, load_at(*row.largest_at), *row.largest_at).change(row.harmonics),
                ulps(5, 1e-3));
  }
}

TEST(TorqueEffect, HigherHarmonicsDoNotChangeTheTorqueAtRest)
{
  for (unsigned int n = 1; n <= 4; ++n)
    EXPECT_NEAR(TorqueByHarmonics(Motion(), load_at(0.), 0.).rest(n), 0., ulps(5, 1e-3));
}

TEST(TorqueEffect, IsComputedOnlyUpToTheTippingSpin)
{
  const Motion motion;
  const Load load(
    [](double omega) -> Sample
    {
      if (omega < -1.)
        throw Tipping("it tips");
      return load_at(omega);
    });
  const Answer all = answer(load, { motion });
  ASSERT_TRUE(all.fall);
  const TorqueEffects effects = torque_effects(load, motion, all, { 1, 4 }, &load);
  EXPECT_FALSE(effects.rows[1].half);
  EXPECT_FALSE(effects.rows[1].terminal);
  EXPECT_DOUBLE_EQ(effects.spins.back(), all.fall->omega);
  EXPECT_TRUE(std::isfinite(effects.rows[1].curve.back()));
}
} // namespace
} // namespace stemware::ring
