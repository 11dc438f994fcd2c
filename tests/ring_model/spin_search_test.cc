#include "ring_model/friction_functionals.h"
#include "ring_model/spin_search.h"
#include "ring_model/terminal_spin.h"
#include "tests/ring_model/reference.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace stemware::ring
{
namespace
{

const double radius = 0.03;
const double scale = 0.35 / radius; ///< spin scale v / R [rad/s]

/// Returns the last spin with a moment balance [rad/s]. Expects the search to throw BalanceLost with a nested
/// @p Cause.
template <typename Cause = Tipping>
double last_spin(const TorqueFunction &torque, const SpinSearch &search)
{
  try
  {
    find_terminal_spin(torque, search);
  }
  catch (const BalanceLost &lost)
  {
    EXPECT_THROW(std::rethrow_if_nested(lost), Cause);
    return lost.last_spin;
  }
  ADD_FAILURE() << "the search returned a spin beyond the loss of balance";
  return std::nan("");
}

/// Returns the number of torques that find_terminal_spin() evaluates.
unsigned int n_evaluations(const TorqueFunction &torque, const SpinSearch &search)
{
  unsigned int n = 0;
  find_terminal_spin(
    [&](double omega)
    {
      ++n;
      return torque(omega);
    },
    search);
  return n;
}

TEST(SpinSearch, ReturnsZeroSpinOnlyIfTheTorqueAtRestIsWithinTheNoise)
{
  const auto torque = [](double omega) { return (omega + 1e-12) * (0.2 - omega); };
  SpinSearch search = { 1. };
  search.torque_noise = 1e-11;
  const TerminalSpin rest = find_terminal_spin(torque, search);
  EXPECT_EQ(rest.omega, 0.);
  EXPECT_FALSE(rest.held);
  search.torque_noise = 1e-14;
  EXPECT_NEAR(find_terminal_spin(torque, search).omega, 0.2, 1e-11);
}

TEST(SpinSearch, RecoversFromABadInitialGuessInFewEvaluations)
{
  const SelfConsistentRing ring(Closure::full, Motion(), radius);
  const auto torque = [&](double omega) { return ring.torque(omega); };
  for (const double expected : { 1e-9, -0.05, -1., -3.7, -11., -20., 3.7, -600. })
  {
    const TerminalSpin zero = find_terminal_spin(torque, { scale, expected });
    expect_relative(zero.omega, -3.678747998525761128, 1e-12, "omega");
    EXPECT_LE(n_evaluations(torque, { scale, expected }), 12u) << expected;
  }
}

TEST(SpinSearch, FindsTheFirstTorqueZeroUnderRandomLoadsInFewEvaluations)
{
  // Reference: all zeros, by a scan of 300 intervals.
  test::Numbers numbers(7);
  unsigned int n_torques = 0;
  for (unsigned int i = 0; i < 200; ++i)
  {
    const RingStack load = numbers.nonnegative_load(8, radius);
    const auto torque = [&](double omega) { return coulomb_wrench(0.3, load, omega, 0.35).torque; };
    const TerminalSpin zero = find_terminal_spin(torque, { scale, load.b(1) * scale });
    const double sign = std::copysign(1., load.b(1));
    const auto all = all_terminal_spins([&](double omega) { return torque(sign * omega); }, 1., scale, 1e-9,
                                        3. * scale, 300);
    ASSERT_FALSE(all.empty());
    EXPECT_NEAR(zero.omega, sign * all.front().omega, 1e-11 * scale) << i;
    n_torques += n_evaluations(torque, { scale, load.b(1) * scale });
  }
  EXPECT_LE(n_torques, 5 * 200u);
}

TEST(SpinSearch, AgreesWithTheClosedFormUnderAGripTorqueInFewEvaluations)
{
  // Closed form for a load of the harmonics 0 and 1: a_0 K_0(eps) + b_1(eps) K_1(eps) = grip sgn(omega) /
  // (mu R), with the friction kernels K_n and eps = omega R / v. For Closure::paper, b_1 is constant. The
  // terminal spins were computed with 40 digits (mpmath, kernels by quadrature).
  struct Row
  {
    Closure closure;
    double grip, omega;
  };
  for (const Row &row : { Row{ Closure::paper, 0., -3.120558701525858902686 },
                          Row{ Closure::paper, 2e-4, -2.957786221000013522103 },
                          Row{ Closure::paper, 1e-3, -2.297718412629718143769 },
                          Row{ Closure::paper, 3e-3, -0.5913208069446393606937 },
                          Row{ Closure::full, 2e-4, -3.49585319473942429094 },
                          Row{ Closure::full, 1e-3, -2.742239997780318092963 },
                          Row{ Closure::full, 3e-3, -0.7186711254385290776323 } })
    for (const OrbitSense sense : { OrbitSense::counterclockwise, OrbitSense::clockwise })
    {
      Motion motion;
      motion.orbit_sense = sense;
      const SelfConsistentRing ring(row.closure, motion, radius);
      const auto torque = [&](double omega) { return ring.torque(omega); };
      const TerminalSpin zero = find_terminal_spin(torque, { scale, -3.1, row.grip });
      expect_relative(zero.omega, motion.sense_sign() * row.omega, 1e-12, "omega");
      EXPECT_LE(n_evaluations(torque, { scale, -3.1, row.grip }), 7u) << row.grip;
      EXPECT_FALSE(zero.held);
    }
}

TEST(SpinSearch, AGlassIsHeldOnlyIfTheGripExceedsANonzeroTorqueAtRest)
{
  const SelfConsistentRing ring(Closure::full, Motion(), radius);
  const auto torque = [&](double omega) { return ring.torque(omega); };
  const TerminalSpin zero = find_terminal_spin(torque, { scale, -3.1, 0.0036751 });
  EXPECT_TRUE(zero.held);
  EXPECT_EQ(zero.omega, 0.);
  EXPECT_EQ(n_evaluations(torque, { scale, -3.1, 0.0036751 }), 1u);
  EXPECT_FALSE(find_terminal_spin(torque, { scale, {}, 0.0036749 }).held);
  const TerminalSpin spin = terminal_spin(torque, 3e-4, SpinSearch{ scale, {}, 0.0036751 });
  EXPECT_TRUE(spin.held && spin.stable && std::isnan(spin.time_constant));
  // The torque vanishes at zero spin, so the terminal spin is zero even without a grip.
  const TerminalSpin upright = find_terminal_spin([](double omega) { return -omega; }, { scale });
  EXPECT_TRUE(upright.omega == 0. && !upright.held);
}

TEST(SpinSearch, ReturnsTheFirstOfSeveralTorqueZeros)
{
  const auto torque = [](double omega) { return -(omega - 1.) * (omega - 3.) * (omega - 4.); };
  expect_relative(find_terminal_spin(torque, { 4., 4.0001 }).omega, 1., 1e-11, "the last one expected");
  expect_relative(find_terminal_spin(torque, { 4., 3.5 }).omega, 1., 1e-11, "a sample between the zeros");
  expect_relative(find_terminal_spin(torque, { 4. }).omega, 1., 1e-11, "nothing expected");
}

TEST(SpinSearch, StepsBackFromSpinsWithoutBalanceAndReportsTheLastBalancedSpin)
{
  const auto torque_up_to = [](double limit, double zero)
  {
    return [=](double omega)
    {
      if (omega > limit)
        throw Tipping("tips");
      return zero - omega - 0.1 * omega * omega / zero + 0.1 * zero;
    };
  };
  const TerminalSpin before = find_terminal_spin(torque_up_to(2.1, 2.), { 10., 5. });
  expect_relative(before.omega, 2., 1e-12, "omega");
  EXPECT_LE(n_evaluations(torque_up_to(2.1, 2.), { 10., 5. }), 8u);
  const double last = last_spin(torque_up_to(2.1, 2.2), { 10., 5. });
  EXPECT_LE(last, 2.1);
  EXPECT_GT(last, 2.1 - 10. / 4096.);
  EXPECT_THROW(find_terminal_spin(torque_up_to(2., 2.0001), { 10., 1. }), BalanceLost);
  EXPECT_THROW(find_terminal_spin(torque_up_to(-1., 2.), { 10. }), Tipping);

  const auto backwards = [&](double omega) { return -torque_up_to(2.1, 2.2)(-omega); };
  EXPECT_NEAR(last_spin(backwards, { 10., -5. }), -2.1, 10. / 4096.);
}

TEST(SpinSearch, FindsALossOfBalanceBeforeADistantTorqueZero)
{
  // The torque rises up to 3 rad/s and vanishes at 6 rad/s, and there is no balance between 1 and 1.2 rad/s.
  // A torque that rises between rest and the zero triggers a scan, which detects this gap.
  const auto torque = [](double omega)
  {
    if (omega > 1. && omega < 1.2)
      throw NoBalance("a gap");
    return omega < 3. ? 1. + omega : 4. * (6. - omega) / 3.;
  };
  EXPECT_NEAR(last_spin<NoBalance>(torque, { 1., 5.9 }), 1., 1. / 4096.);
}

TEST(SpinSearch, FindsANarrowGapWithoutBalanceByTheStabilityMargin)
{
  // The balance ends in a fold, where the stability margin vanishes like the square root of the distance to
  // the fold.
  const double middle = 0.7;
  const auto square = [=](double omega, double least)
  { return std::min(1., least + 2. * std::pow(omega - middle, 2)); };
  for (const double half_width : { 0.05, 0.01, 1e-3 })
    for (const double sense : { 1., -1. })
    {
      const double least = -2. * half_width * half_width;
      const auto torque = [=](double omega)
      {
        if (square(sense * omega, least) < 0.)
          throw Tipping("a fold");
        return sense - omega;
      };
      SpinSearch search{ 1., 0.99 * sense };
      search.stability_margin = [=](double omega) { return std::sqrt(square(sense * omega, least)); };
      EXPECT_NEAR(last_spin(torque, search), sense * (middle - half_width), 1. / 4096.) << half_width;
      EXPECT_FALSE(find_terminal_spin_near({ sense, -1. }, torque, search)) << "0.99 is next to a fold";
    }
}

TEST(SpinSearch, FindsTheZeroNextToASimilarOne)
{
  const auto torque = [](double omega) { return 1.001 - omega - 0.1 * (omega - 1.001) * (omega - 1.001); };
  const std::optional<TerminalSpin> zero = find_terminal_spin_near({ 1., -1.1 }, torque, { 10. });
  ASSERT_TRUE(zero);
  EXPECT_NEAR(zero->omega, 1.001, 1e-11);
  EXPECT_NEAR(zero->evaluated_at, zero->omega, 1.1e-7);
}

TEST(SpinSearch, ReportsTippingAtATorqueJumpButNotAtASteepContinuousDrop)
{
  // At 0.7 rad/s, a second balance begins and the torque jumps by `drop`. `beyond` is added to the stability
  // margin of the second balance. A change of the torque by `drop` over 2e-3 rad/s is no jump.
  const double end = 0.7, drop = 0.05;
  for (const double width : { 0., 2e-3 })
    for (const double beyond : { 0.1, 0.5 })
    {
      const auto torque = [=](double omega)
      {
        const double share =
          width > 0. ? std::min(1., std::max(0., (omega - end) / width + 0.5)) : omega > end;
        return 1. - omega - drop * share;
      };
      SpinSearch search{ 1., 0.94 };
      search.stability_margin = [=](double omega)
      { return std::min(1., std::sqrt(1e-4 + std::abs(omega - end)) + (omega > end ? beyond : 0.)); };
      if (width > 0.)
      {
        EXPECT_NEAR(find_terminal_spin(torque, search).omega, 0.95, 1e-9) << beyond;
        continue;
      }
      try
      {
        find_terminal_spin(torque, search);
        ADD_FAILURE() << "the jump was not detected, margin " << beyond;
      }
      catch (const BalanceLost &lost)
      {
        EXPECT_TRUE(lost.tips());
        EXPECT_NEAR(lost.last_spin, end, 1e-4);
      }
    }
}

TEST(SpinSearch, StopsAtTheGivenToleranceUnderANoisyTorque)
{
  const auto torque = [](double omega) { return 1. - omega + 1e-9 * std::sin(1e12 * omega); };
  SpinSearch search{ 3. };
  search.tolerance = 1e-7;
  const TerminalSpin zero = find_terminal_spin(torque, search);
  EXPECT_NEAR(zero.omega, 1., 1e-7);
  EXPECT_LE(n_evaluations(torque, search), 5u);
  EXPECT_NEAR(find_terminal_spin(torque, { 3. }).omega, 1., 3e-9);
}

TEST(SpinSearch, RefusesTorquesWithoutATerminalSpinAndInvalidArguments)
{
  EXPECT_THROW(find_terminal_spin([](double) { return 1.; }, { 1. }), NoTerminalSpin);
  EXPECT_THROW(find_terminal_spin([](double omega) { return 1. + omega; }, { 1. }), NoTerminalSpin);
  EXPECT_THROW(find_terminal_spin([](double) { return std::nan(""); }, { 1. }), std::runtime_error);
  EXPECT_THROW(find_terminal_spin([](double omega) { return 1. - omega; }, { 0. }), std::invalid_argument);
  EXPECT_THROW(find_terminal_spin([](double omega) { return 1. - omega; }, { 1., {}, -1. }),
               std::invalid_argument);
}
} // namespace
} // namespace stemware::ring
