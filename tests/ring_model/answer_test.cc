// The ring's own question, asked of loads from a lambda. References: the closed form of the first harmonic,
// fixed steps of the classical Runge-Kutta method, energy.
#include "ring_model/friction_functionals.h"
#include "ring_model/self_consistent_ring.h"
#include "ring_model/spin/answer.h"
#include "tests/ring_model/reference.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
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
LoadFromFunction balanced_load(const Motion &motion)
{
  return LoadFromFunction([ring = SelfConsistentRing(Closure::full, motion, radius)](
                            double omega) -> LeaningLoad { return ring.at(omega).load; });
}

TEST(AskedAnswer, HasTheTerminalSpinOfTheClosedForm)
{
  const Motion motion = paper_motion();
  const SelfConsistentRing ring(Closure::full, motion, radius);
  Question question = { motion };
  question.with_slope = question.all_spins = true;
  question.spins = { 0, -2. };
  const Answer found = answer(balanced_load(motion), question).value();
  const TerminalSpin exact = test::terminal_spin_of(ring, motion, radius);
  EXPECT_NEAR(found.terminal->omega, exact.omega, 1e-10);
  EXPECT_NEAR(*found.time_constant(), exact.time_constant, 1e-5 * exact.time_constant);
  EXPECT_EQ(found.status, Status::full_contact);
  EXPECT_EQ(found.harmonics, 1u);
  ASSERT_EQ(found.torques.size(), 2u);
  EXPECT_NEAR(found.torques[0].torque(), ring.torque(0), 1e-16);
  EXPECT_NEAR(found.torques[1].torque(), ring.torque(-2), 1e-16);
  ASSERT_EQ(found.all_spins.size(), 1u);
  EXPECT_EQ(found.all_spins.front().omega, found.terminal->omega);
}

TEST(AskedAnswer, SpinsUpAsRungeKuttaSays)
{
  const Motion motion = paper_motion();
  const SelfConsistentRing ring(Closure::full, motion, radius);
  constexpr double grip = 1e-4; // N m
  Question question = { motion, grip };
  question.times = { 0, 0.05, 0.1 };
  question.euler_step = 1e-5;
  const Answer found = answer(balanced_load(motion), question).value();
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
  ASSERT_EQ(found.spin_up.size(), 3u);
  ASSERT_EQ(found.euler.size(), 3u);
  EXPECT_NEAR(found.spin_up[2].omega, omega, 1e-8);
  EXPECT_NEAR(found.euler[2].omega, omega, 1e-3); // first order
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
  question.times = { 0, 0.5, 1.5 };
  answer(load, question).value();
  EXPECT_DOUBLE_EQ(latest, 1.5);
  question.observer = [](double) { throw std::domain_error("enough"); };
  EXPECT_THROW(answer(load, question), std::domain_error);
}

TEST(AskedAnswer, AFallKeepsItsLastSpin)
{
  const Motion motion = paper_motion();
  const SelfConsistentRing ring(Closure::full, motion, radius);
  const LoadFromFunction load(
    [&](double omega) -> LeaningLoad
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

TEST(AskedAnswer, ATruncatedLoadLosesHarmonicsAlone)
{
  const RingStack rich({ 0.47, 0.1, 0.03 }, { 0., 0.3, -0.02 }, radius);
  const auto load = std::make_shared<LoadFromFunction>([=](double) -> LeaningLoad { return rich; });
  const Answer all = answer(*load, { Motion() }), one = answer(*truncated(load, 1), { Motion() });
  EXPECT_EQ(all.harmonics, 2u);
  EXPECT_EQ(one.harmonics, 1u);
  const Answer related = compared_with_all(one, all, *load, Motion());
  EXPECT_NEAR(*related.relative_change, one.terminal->omega / all.terminal->omega - 1, 1e-15);
}

TEST(AskedAnswer, AFormalLoadPullsWhereItsFirstHarmonicIsNegative)
{
  constexpr double m = 1.3, pi = 3.14159265358979323846;
  const LoadFromFunction load([](double) -> LeaningLoad { return RingStack({ 1., 0. }, { 0., m }, radius); });
  const Answer found = answer(load, { Motion() }).value();
  ASSERT_TRUE(found.at_rest);
  EXPECT_NEAR(found.at_rest->minimum, 1 - m, 1e-12);
  EXPECT_NEAR(found.at_rest->pulling_share, (std::sqrt(m * m - 1) - std::acos(1 / m)) / pi, 1e-12);
}
} // namespace
