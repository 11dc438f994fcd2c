#include "fem/pipeline/analysis/spin_study.h"
#include "fem/pipeline/analysis/threaded_executor.h"
#include "fem/pipeline/coupling/make_foot.h"
#include "fem/pipeline/coupling/study_load.h"
#include "ring_model/spin/answer.h"
#include "tests/fem/pipeline/analysis/quick_studies.h"
#include "tests/fem/pipeline/mat_study.h"
#include "tests/fem/pipeline/matchers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace stemware::pipeline
{
namespace
{

using namespace stemware::test;

SpinStudy study_spin_of(const ring::RingStack &load, const Study &study = study_of_given_load())
{
  fem::ComplianceCache cache;
  return study_spin({ study, nullptr, ThreadedExecutor(cache) }, given_load(load));
}

TEST(SpinStudy, SpinUpCurvesAgreeWithIndependentIntegrations)
{
  // Reference: midpoint rule with 4000 steps.
  const Study study = study_of_given_load();
  const ring::Motion &motion = study.motion.orbit;
  const SpinUpCurves curves = study_spin_of(rich_load(), study).spin_up;
  const auto final_spin = [&](const ring::RingStack &load)
  {
    double omega = 0;
    const int n_steps = 4000;
    const double step = study.motion.end_time / n_steps;
    const auto rate = [&](double spin)
    {
      return ring::coulomb_wrench(motion.friction_coefficient, load, spin, motion.orbit_speed).torque /
             motion.yaw_inertia;
    };
    for (int i = 0; i < n_steps; ++i)
      omega += step * rate(omega + step / 2 * rate(omega));
    return omega;
  };
  EXPECT_NEAR(curves.adaptive.back(), final_spin(rich_load()), 1e-6);
  EXPECT_NEAR(curves.first_harmonic.back(), final_spin(rich_load().truncated(1)), 1e-6);
  // The load of the paper's model does not depend on the spin.
  EXPECT_NEAR(curves.paper.back(),
              final_spin(ring::RingStack::first_harmonic(
                motion.normal_force(), ring::required_moment_at_rest(ring::Closure::paper, motion), 0.03)),
              1e-6);
  EXPECT_GT(std::abs(curves.euler.back() - curves.adaptive.back()), 1e-6);
  EXPECT_NEAR(curves.euler.back(), curves.adaptive.back(), 1e-2);
}

TEST(SpinStudy, SolvesTheMomentBalanceAnewForEachTruncatedLoad)
{
  const Study study = quick_contact_study();
  fem::ComplianceCache cache;
  const auto foot = study_foot(study, foot_maker(cache));
  const SpinStudy two_way = study_spin({ study, foot, ThreadedExecutor(cache) }, find_load(study, foot));
  ASSERT_GE(two_way.rows.by_harmonics.size(), 4u);
  for (std::size_t i = 0; i < 3; ++i)
  {
    const auto n = static_cast<unsigned int>(i + 1);
    const ring::Answer &row = two_way.rows.by_harmonics[i].row;
    EXPECT_NEAR(
      *row.omega_terminal(),
      *ring::answer(find_load(study, foot, silent_progress(), n), { study.motion.orbit }).omega_terminal(),
      1e-9)
      << n;
  }
  EXPECT_EQ(find_budget(two_way.rows).rows.back().omega_terminal, two_way.answer().omega_terminal());
}

TEST(SpinStudy, ComparesWithOneRingOnlyIfTheStudyHasSeveralRings)
{
  Study study = quick_contact_study();
  fem::ComplianceCache cache;
  const auto foot = study_foot(study, foot_maker(cache));
  EXPECT_TRUE(study_spin({ study, foot, ThreadedExecutor(cache) }, find_load(study, foot)).one_ring);
  study.contact.rings = 1;
  const auto on_one_ring = study_foot(study, foot_maker(cache));
  EXPECT_FALSE(
    study_spin({ study, on_one_ring, ThreadedExecutor(cache) }, find_load(study, on_one_ring)).one_ring);
}

TEST(SpinStudy, ReportsProgressAndCanBeInterruptedDuringTheSpinUp)
{
  struct Listener : Progress
  {
    void pieces_done(const std::string &, std::size_t n_done, std::size_t n_all) override
    {
      if (n_all > 0) // progress of the model rows, not of the spin-up
        return;
      most = std::max(most, n_done);
      if (is_interrupted)
        throw std::domain_error("interrupted");
    }
    std::size_t most = 0;
    bool is_interrupted = false;
  } listener;
  fem::ComplianceCache cache;
  const auto study_the_spin = [&]
  {
    study_spin({ study_of_given_load(), nullptr, ThreadedExecutor(cache, 1, listener) },
               given_load(rich_load()), Depth::answer);
  };
  study_the_spin();
  EXPECT_GE(listener.most, 1u);
  listener.is_interrupted = true;
  EXPECT_THROW(study_the_spin(), std::domain_error);
}

BalancedLoad tipping_beyond(double last)
{
  const auto load = [last](double omega) -> ring::Sample
  {
    if (std::abs(omega) > last)
      throw ring::Tipping("it tips");
    return rich_load();
  };
  return { ring::Load(load), report_of(rich_load()) };
}

// Rest is unstable if the hand is at the centre of mass and friction decreases with the slip. Reference: a
// glass whose hand is 1e-6 m lower spins up.
TEST(SpinStudy, ReportsThatRestIsUnstableAndThatASmallOffsetSpinsTheGlassUp)
{
  Study study = test::mat_study();
  study.load.source = LoadSource::first_harmonic;
  study.motion.orbit.force_offset = 0;
  study.motion.orbit.orbit_speed = 0.1;
  study.motion.orbit.friction_law = ring::FrictionLawKind::stribeck;
  fem::ComplianceCache cache;
  const auto solve = [&] {
    return study_spin({ study, nullptr, ThreadedExecutor(cache) }, find_load(study, nullptr), Depth::answer);
  };
  const SpinStudy upright = solve();
  ASSERT_TRUE(upright.answer().terminal);
  EXPECT_EQ(upright.answer().terminal->omega, 0);
  EXPECT_FALSE(upright.answer().terminal->stable);
  study.motion.orbit.force_offset = -1e-6;
  const double started = solve().answer().omega_terminal().value();
  EXPECT_NEAR(started, -2.4364, 1e-4);
}

// Up to tipping, the load does not depend on the spin. References: the moment ratio of the first harmonic;
// the time of tipping by Simpson's rule, from dt = yaw_inertia / torque(omega) d omega.
TEST(SpinStudy, ReportsTippingDuringTheSpinUp)
{
  const Study study = study_of_given_load();
  const ring::Motion &motion = study.motion.orbit;
  fem::ComplianceCache cache;
  const SpinStudy fallen = study_spin({ study, nullptr, ThreadedExecutor(cache) }, tipping_beyond(2.5));
  const ring::Answer &row = fallen.answer();
  EXPECT_EQ(row.status, ring::Status::tips);
  EXPECT_FALSE(row.terminal);
  ASSERT_TRUE(row.fall);
  EXPECT_NEAR(row.fall->omega, -2.5, 0.35 / 0.03 / 4096);
  EXPECT_NEAR(row.fall->moment_ratio, std::hypot(0.1, 0.3) / 0.47, 1e-12);
  EXPECT_EQ(row.at_rest->friction.torque, study_spin_of(rich_load()).answer().at_rest->friction.torque);
  EXPECT_TRUE(fallen.terminal_spins.empty());
  const Budget budget = find_budget(fallen.rows);
  EXPECT_FALSE(budget.rows.back().omega_terminal);
  EXPECT_EQ(budget.rows.back().status, ring::Status::tips);
  EXPECT_FALSE(harmonic_effect(fallen.rows).absolute);

  const auto time_per_spin = [&](double omega)
  {
    return motion.yaw_inertia /
           ring::coulomb_wrench(motion.friction_coefficient, rich_load(), omega, motion.orbit_speed).torque;
  };
  double time = 0;
  constexpr int n_intervals = 200;
  const double step = row.fall->omega / n_intervals;
  for (int i = 0; i < n_intervals; ++i)
    time += step / 6 *
            (time_per_spin(i * step) + 4 * time_per_spin((i + 0.5) * step) + time_per_spin((i + 1) * step));
  const SpinUpCurves &curves = fallen.spin_up;
  ASSERT_LT(time, curves.time.back());
  for (std::size_t i = 0; i < curves.time.size(); ++i)
  {
    EXPECT_EQ(std::isnan(curves.adaptive[i]), curves.time[i] > time) << i;
    EXPECT_EQ(std::isnan(curves.yaw_angle[i]), curves.time[i] > time) << i;
  }
  const auto [least, most] = std::minmax_element(fallen.torque.omega.begin(), fallen.torque.omega.end());
  EXPECT_EQ(*least, row.fall->omega);
  EXPECT_GT(*most, 0);
}

TEST(Answer, GivesTheStatusAndTheReasonForAMissingSpinAndRethrowsOtherErrors)
{
  const auto refusing = [](auto failure)
  {
    return ring::Load(
      [failure](double omega) -> ring::Sample
      {
        if (omega != 0)
          throw failure;
        return rich_load();
      });
  };
  const ring::Question question = { ring::Motion() };
  const ring::Answer tips = ring::answer(refusing(ring::Tipping("it tips")), question);
  EXPECT_EQ(tips.status, ring::Status::tips);
  EXPECT_NE(tips.reason.find("at 0 rad/s and a moment ratio of 0.673"), std::string::npos) << tips.reason;
  EXPECT_TRUE(tips.at_rest);
  EXPECT_FALSE(tips.terminal);
  const ring::Answer none = ring::answer(refusing(ring::NoBalance("none")), question);
  EXPECT_EQ(none.status, ring::Status::no_balance);
  EXPECT_THAT(none.reason, testing::HasSubstr("none"));
  EXPECT_THROW(ring::answer(refusing(std::runtime_error("a fault")), question), std::runtime_error);
  // The torque has no zero if the moment grows faster (like omega^3) than the kernel K_1 decreases.
  const auto with_ratio = [](double m) {
    return ring::RingStack::first_harmonic(2.943, { m * 2.943 * 0.03 / 2, 0 }, 0.03);
  };
  const auto growing = [=](double omega) -> ring::Sample
  { return with_ratio(4 + 10 * std::pow(std::abs(omega) * 0.03 / 0.35, 3)); };
  const ring::Answer endless = ring::answer(ring::Load(growing), question);
  EXPECT_EQ(endless.status, ring::Status::no_terminal_spin);
  EXPECT_EQ(ring::answer(given_load(with_ratio(1.5)), question).status, ring::Status::formal);
  EXPECT_EQ(ring::answer(given_load(rich_load()), question).status, ring::Status::full_contact);
}

} // namespace
} // namespace stemware::pipeline
