// The ring's own question, asked of loads from a lambda. References: the closed form of the first harmonic,
// fixed steps of the classical Runge-Kutta method, energy.
#include "ring_model/friction_functionals.h"
#include "ring_model/self_consistent_ring.h"
#include "ring_model/spin/answer.h"
#include "ring_model/spin/curves.h"
#include "tests/ring_model/reference.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace
{
using namespace stemware::ring;

constexpr double radius = 0.03; // m

Motion paper_motion()
{
  Motion motion;
  motion.force_offset = -0.05;
  return motion;
}

/// The load of the paper's glass in balance at every spin.
Load balanced_load(const Motion &motion)
{
  return Load([ring = SelfConsistentRing(Closure::full, motion, radius)](double omega) -> Sample
              { return ring.at(omega).load; });
}

TEST(AskedAnswer, HasTheTerminalSpinOfTheClosedForm)
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
  EXPECT_NEAR(torques[0].torque(), ring.torque(0), 1e-16);
  EXPECT_NEAR(torques[1].torque(), ring.torque(-2), 1e-16);
  const std::vector<TerminalSpin> all = terminal_spins(load, question, found);
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all.front().omega, found.terminal->omega);
}

TEST(AskedAnswer, SpinsUpAsRungeKuttaSays)
{
  const Motion motion = paper_motion();
  const SelfConsistentRing ring(Closure::full, motion, radius);
  constexpr double grip = 1e-4; // N m
  const Question question = { motion, grip };
  const std::vector<double> times = { 0, 0.05, 0.1 };
  const Load load = balanced_load(motion);
  const std::vector<YawSample> adaptive = spin_up(load, question, times),
                               euler = euler_spin_up(load, question, times, 1e-5);
  const auto rate = [&](double omega) { return (ring.torque(omega) + grip) / motion.yaw_inertia; };
  double omega = 0;
  constexpr int n_steps = 1000;
  const double step = 0.1 / n_steps;
  for (int i = 0; i < n_steps; ++i)
  {
    const double k1 = rate(omega), k2 = rate(omega + step / 2 * k1), k3 = rate(omega + step / 2 * k2),
                 k4 = rate(omega + step * k3);
    omega += step / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  ASSERT_EQ(adaptive.size(), 3u);
  ASSERT_EQ(euler.size(), 3u);
  EXPECT_NEAR(adaptive[2].omega, omega, 1e-8);
  EXPECT_NEAR(euler[2].omega, omega, 1e-3); // first order
}

TEST(AskedAnswer, IsObservedWhileTheSpinIsFollowed)
{
  const Motion motion = paper_motion();
  const auto load = balanced_load(motion);
  Question question = { motion };
  double latest = -1.;
  question.observer = [&](double time) { latest = std::max(latest, time); };
  answer(load, question).value();
  EXPECT_EQ(latest, -1.); // no motion was asked for
  const std::vector<double> times = { 0, 0.5, 1.5 };
  spin_up(load, question, times);
  EXPECT_DOUBLE_EQ(latest, 1.5);
  question.observer = [](double) { throw std::domain_error("enough"); };
  EXPECT_THROW(spin_up(load, question, times), std::domain_error);
}

TEST(AskedAnswer, AFallKeepsItsLastSpin)
{
  const Motion motion = paper_motion();
  const SelfConsistentRing ring(Closure::full, motion, radius);
  const Load load(
    [&](double omega) -> Sample
    {
      if (omega < -2.)
        throw Tipping("it tips");
      return ring.at(omega).load;
    });
  const Answer found = answer(load, { motion });
  EXPECT_EQ(found.status, Status::tips);
  EXPECT_FALSE(found.terminal);
  EXPECT_FALSE(found.failure); // an answer
  ASSERT_TRUE(found.fall);
  EXPECT_NEAR(found.fall->omega, -2., motion.orbit_speed / radius / 4096);
}

TEST(Load, IsSolvedOnceAtEachSpin)
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

TEST(AskedAnswer, ATruncatedLoadLosesHarmonicsAlone)
{
  const RingStack rich({ 0.47, 0.1, 0.03 }, { 0., 0.3, -0.02 }, radius);
  const Load load([=](double) -> Sample { return rich; });
  const Answer all = answer(load, { Motion() }), one = answer(load.truncated(1), { Motion() });
  EXPECT_EQ(all.harmonics, 2u);
  EXPECT_EQ(one.harmonics, 1u);
  const Answer related = compared_with_all(one, all, load, Motion());
  EXPECT_NEAR(*related.relative_change, one.terminal->omega / all.terminal->omega - 1, 1e-15);
}

TEST(AskedAnswer, AFormalLoadPullsWhereItsFirstHarmonicIsNegative)
{
  constexpr double m = 1.3, pi = 3.14159265358979323846;
  const Load load([](double) -> Sample { return RingStack({ 1., 0. }, { 0., m }, radius); });
  const Answer found = answer(load, { Motion() }).value();
  ASSERT_TRUE(found.at_rest);
  EXPECT_NEAR(found.at_rest->minimum, 1 - m, 1e-12);
  EXPECT_NEAR(found.at_rest->pulling_share, (std::sqrt(m * m - 1) - std::acos(1 / m)) / pi, 1e-12);
}
} // namespace
