#include "ring_model/friction_functionals.h"
#include "ring_model/load/constants.h"
#include "ring_model/self_consistent_ring.h"
#include "ring_model/spin/answer.h"
#include "ring_model/spin/curves.h"
#include "tests/ring_model/quadrature.h"
#include "tests/ring_model/reference.h"
#include "tests/ulps.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace
{
using namespace stemware::ring;

constexpr double radius = 0.03; // [m]

Motion paper_motion()
{
  Motion motion;
  motion.force_offset = -0.05;
  return motion;
}

Load balanced_load(const Motion &motion)
{
  return Load([ring = SelfConsistentRing(Closure::full, motion, radius)](double omega) -> Sample
              { return ring.at(omega).load; });
}

TEST(Answer, TerminalSpinTimeConstantAndTorquesAgreeWithTheSelfConsistentRing)
{
  const Motion motion = paper_motion();
  const SelfConsistentRing ring(Closure::full, motion, radius);
  Question question = { motion };
  question.with_slope = true;
  const Load load = balanced_load(motion);
  const Answer found = answer(load, question).value();
  const TerminalSpin exact = test::terminal_spin_of(ring, motion, radius);
  EXPECT_NEAR(found.terminal->omega, exact.omega, 1e-10);
  EXPECT_NEAR(*found.time_constant(), exact.time_constant, 1e-5 * exact.time_constant);
  EXPECT_EQ(found.status, Status::full_contact);
  EXPECT_EQ(found.harmonics, 1u);
  const std::vector<Torques> torques = torque_curve(load, question, { 0, -2. });
  ASSERT_EQ(torques.size(), 2u);
  EXPECT_NEAR(torques[0].torque(), ring.torque(0), stemware::ulps(130, ring.torque(0)));
  EXPECT_NEAR(torques[1].torque(), ring.torque(-2), stemware::ulps(130, ring.torque(0)));
  const std::vector<TerminalSpin> all = terminal_spins(load, question, found);
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all.front().omega, found.terminal->omega);
}

TEST(Load, SolvesEachSpinOnceAndStoresUnbalancedSpins)
{
  unsigned int n_solved = 0;
  const auto solve = [&](double omega) -> Sample
  {
    ++n_solved;
    if (std::abs(omega) > 2.)
      throw Tipping("it tips");
    return RingStack({ 1., 0., 0.1 }, { 0., 0.3 + 0.01 * omega, 0. }, radius);
  };
  const Load load = Load::solved_once(solve, solve(0.)), cut = load.truncated(1);
  for (const double omega : { 0., 1., -1., 1., 0. })
    EXPECT_EQ(load.at(omega).b(1), cut.at(omega).b(1)) << omega;
  EXPECT_EQ(n_solved, 3u);
  EXPECT_EQ(cut.n_harmonics(), 1u);
  for (const double omega : { 3., 2.5, 3. })
    EXPECT_THROW(cut.at(omega), Tipping) << omega;
  EXPECT_EQ(n_solved, 5u);
  EXPECT_EQ(load.nearest_unbalanced_spin(4.), 2.5);
  EXPECT_FALSE(load.nearest_unbalanced_spin(2.2));
}

TEST(Answer, ComparesTheSpinsUnderTheTruncatedAndTheFullLoad)
{
  const RingStack rich({ 0.47, 0.1, 0.03 }, { 0., 0.3, -0.02 }, radius);
  const Load load([=](double) -> Sample { return rich; });
  const Answer all = answer(load, { Motion() }), one = answer(load.truncated(1), { Motion() });
  EXPECT_EQ(all.harmonics, 2u);
  EXPECT_EQ(one.harmonics, 1u);
  const Answer related = compared_with_all(one, all, load, Motion());
  EXPECT_NEAR(*related.relative_change, one.terminal->omega / all.terminal->omega - 1, stemware::ulps(5, 1));
}

TEST(Answer, GivesTheMinimumAndTheTensileShareOfAPartlyNegativeLoad)
{
  constexpr double m = 1.3;
  const Load load([](double) -> Sample { return RingStack({ 1., 0. }, { 0., m }, radius); });
  const Answer found = answer(load, { Motion() }).value();
  ASSERT_TRUE(found.at_rest);
  EXPECT_NEAR(found.at_rest->minimum, 1 - m, 1e-12);
  EXPECT_NEAR(found.at_rest->pulling_share, (std::sqrt(m * m - 1) - std::acos(1 / m)) / pi, 1e-12);
}
TEST(Answer, FindsAllTerminalSpinsWithTheirStability)
{
  // Stribeck friction and a small moment give three terminal spins. Reference: sign changes of the torque by
  // the trapezoidal rule.
  Motion motion;
  motion.force_offset = -0.01;
  motion.friction_law = FrictionLawKind::stribeck;
  motion.static_coefficient = 1.;
  motion.friction_coefficient = 0.2;
  motion.friction_decay_speed = 0.3;
  const RingStack rings = SelfConsistentRing(Closure::paper, motion, radius).at(0.).load;
  const Load load([&](double) -> Sample { return rings; });
  const Answer found = answer(load, { motion }).value();
  const std::vector<TerminalSpin> all = terminal_spins(load, { motion }, found);
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(all.front().omega, found.terminal->omega);
  const auto torque = [&](double omega)
  {
    const auto mu = [&](double slip)
    {
      const double ratio = slip / motion.friction_decay_speed;
      return motion.friction_coefficient +
             (motion.static_coefficient - motion.friction_coefficient) * std::exp(-ratio * ratio);
    };
    return test::wrench_by_quadrature(mu, rings, omega, motion.orbit_speed, 4000).torque;
  };
  for (const TerminalSpin &spin : all)
  {
    const double below = torque(spin.omega - 1e-6), above = torque(spin.omega + 1e-6);
    EXPECT_LT(below * above, 0.) << spin.omega;
    EXPECT_EQ(spin.stable, above < below) << spin.omega;
  }
}
} // namespace
