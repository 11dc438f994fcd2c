#include "fem/meridian/compliance_cache.h"
#include "fem/pipeline/analysis/fit.h"
#include "fem/pipeline/answer/threaded_executor.h"
#include "fem/pipeline/input/study_file.h"
#include "fem/pipeline/pictures/fit_pictures.h"
#include "tests/fem/pipeline/analysis/synthetic_run.h"
#include "tests/fem/pipeline/matchers.h"
#include "tests/fem/pipeline/refusal.h"

#include <gtest/gtest.h>

#include <array>
#include <iostream>
#include <vector>

namespace stemware::pipeline
{
namespace
{

using test::Sensor;
using test::Truth;

constexpr std::array<const char *, 4> names = { "gyroscope", "gyroscope, start missed", "film, each frame",
                                                "film, eighths of turns" };

/// Study of a first harmonic with the hand of @p truth; friction and grip are other ones.
Study study_of(const Truth &truth)
{
  return read_study("", { "Load/Source=first harmonic", "Motion/Friction coefficient=0.27",
                          "Motion/Grip torque=5e-4",
                          "Motion/Force offset=" + std::to_string(truth.force_offset) });
}

FitResult fit_friction_and_grip(const std::vector<RunToFit> &runs, bool with_profiles = false)
{
  fem::ComplianceCache cache(1);
  FitQuestion question;
  question.free = { { "Motion/Friction coefficient" }, { "Motion/Grip torque" } };
  question.with_profiles = question.with_next_run = with_profiles;
  return fit(runs, question, ThreadedExecutor(cache));
}

/// How many truths lie in their intervals.
struct Coverage
{
  int n = 0, in_68 = 0, in_95 = 0;
};

/// Fits the first @p n runs of each seed; prints the table by sensor. Returns the sum.
Coverage cover(int n)
{
  std::array<Coverage, 4> all;
  for (const unsigned int seed : test::seeds_of_runs)
  {
    std::mt19937 random(seed);
    for (int k = 0; k < n; ++k)
    {
      Truth truth;
      truth.friction = std::uniform_real_distribution<double>(0.2, 0.35)(random);
      truth.grip = std::uniform_real_distribution<double>(2e-4, 1e-3)(random);
      const auto sensor = static_cast<std::size_t>(k % 4);
      const MeasuredRun data = test::measured(test::TrueMotion(truth), static_cast<Sensor>(sensor), random);
      const FitResult found = fit_friction_and_grip({ { "run.csv", study_of(truth), data } });
      for (const auto &[entry, value] : { std::pair(0, truth.friction), std::pair(1, truth.grip) })
      {
        const auto is_in = [&, value = value](const FittedRange &range)
        { return range.lower <= value && value <= range.upper ? 1 : 0; };
        const FittedEntry &fitted = found.entries.at(static_cast<std::size_t>(entry));
        ++all[sensor].n;
        all[sensor].in_68 += is_in(fitted.range_68);
        all[sensor].in_95 += is_in(fitted.range_95);
      }
    }
  }
  Coverage sum;
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    std::cout << names[i] << ": " << all[i].n << " truths, " << 100. * all[i].in_68 / all[i].n
              << " % in 68 %, " << 100. * all[i].in_95 / all[i].n << " % in 95 %" << std::endl;
    sum = { sum.n + all[i].n, sum.in_68 + all[i].in_68, sum.in_95 + all[i].in_95 };
  }
  std::cout << "all: " << sum.n << " truths, " << 100. * sum.in_68 / sum.n << " %, "
            << 100. * sum.in_95 / sum.n << " %" << std::endl;
  return sum;
}

/// The long test has 402 runs; here a binomial count of 48 stays within three of its standard deviations.
TEST(Fit, TruthsOfAFewRunsLieInTheirIntervals)
{
  const Coverage found = cover(8);
  EXPECT_NEAR(found.in_68, 0.68 * found.n, 3 * std::sqrt(0.68 * 0.32 * found.n));
  EXPECT_GE(found.in_95, 0.95 * found.n - 3 * std::sqrt(0.95 * 0.05 * found.n));
}

TEST(Fit, TruthsOf402RunsLieInTheirIntervalsLong)
{
  const Coverage found = cover(134);
  EXPECT_GE(found.in_68, 0.64 * found.n);
  EXPECT_LE(found.in_68, 0.72 * found.n);
  EXPECT_GE(found.in_95, 0.93 * found.n);
  EXPECT_LE(found.in_95, 0.97 * found.n);
}

/// From one run friction and grip are known together; a hand at another height separates them.
TEST(Fit, TwoHandsSeparateFrictionAndGrip)
{
  Truth low, high;
  high.force_offset = -0.02;
  std::mt19937 random(test::seeds_of_runs[0]);
  const auto run = [&](const Truth &truth)
  {
    return RunToFit{ "run.csv", study_of(truth),
                     test::measured(test::TrueMotion(truth), Sensor::film_turns, random) };
  };
  const RunToFit first = run(low), second = run(high);
  const FitResult alone = fit_friction_and_grip({ first }, true),
                  both = fit_friction_and_grip({ first, second });
  EXPECT_GT(alone.correlation(0, 1), 0.99);
  EXPECT_LT(both.entries[1].spread, alone.entries[1].spread / 3);
  ASSERT_TRUE(alone.next_run);
  EXPECT_LT(alone.next_run->spread_then, alone.next_run->spread_now / 3);
  EXPECT_THAT(alone.sentences.front().text, testing::HasSubstr("together"));
}

/// A noise-free curve has the truth, and its profile is the parabola of the covariance.
TEST(Fit, TruthComesBack)
{
  const Truth truth;
  const test::TrueMotion motion(truth);
  RunToFit run = { "run.csv", study_of(truth), {} };
  for (int i = 0; i < 120; ++i)
  {
    run.data.times.push_back(5 + 0.01 * i);
    run.data.values.push_back(motion.spin(0.01 * i - 0.1) + (i % 2 == 0 ? 1e-3 : -1e-3));
  }
  const FitResult found = fit_friction_and_grip({ run }, true);
  EXPECT_NEAR(found.entries[0].value, truth.friction, 2e-4);
  EXPECT_NEAR(found.entries[1].value, truth.grip, 2e-6);
  EXPECT_NEAR(found.runs[0].start, 5.1, 1e-4);
  EXPECT_NEAR(found.runs[0].noise, 1e-3, 1e-4);
  for (const FittedEntry &entry : found.entries)
  {
    EXPECT_NEAR(entry.profile_68->lower, entry.range_68.lower, 0.1 * entry.spread);
    EXPECT_NEAR(entry.profile_95->upper, entry.range_95.upper, 0.3 * entry.spread);
    EXPECT_FALSE(entry.band);
  }
}

/// An entry that is fitted as a logarithm, and one that ends at 0, have no negative values with 95 %.
TEST(Fit, EllipsesOfPositiveEntriesDoNotReachBelowZero)
{
  FitResult found;
  found.entries.resize(2);
  FittedEntry &one = found.entries[0], &other = found.entries[1];
  one.value = 0.3;
  one.spread = 0.3;
  one.is_positive = true;
  other.value = 4e-4;
  other.spread = 3e-4;
  other.is_never_negative = true;
  found.correlation = Eigen::Matrix2d::Identity();
  found.correlation(0, 1) = found.correlation(1, 0) = 0.6;
  Pictures pictures;
  add_fit_columns(found, pictures);
  const auto &columns = pictures.tables.at("fit_ellipse_1_2")["values"];
  const auto x = columns[0].get<std::vector<double>>(), y = columns[1].get<std::vector<double>>();
  EXPECT_THAT(x, testing::Each(testing::Gt(0.)));
  EXPECT_THAT(y, testing::Each(testing::Ge(0.)));
  EXPECT_THAT(y, testing::Contains(0.));
  EXPECT_EQ(x.front(), x.back());
  EXPECT_EQ(y.front(), y.back());
}

TEST(Fit, PriorsAreReadAndBadOnesRefused)
{
  const FreeEntry mass = parse_free_entry("Motion/Mass = 300 ± 2 g");
  EXPECT_EQ(mass.path, "Motion/Mass");
  EXPECT_DOUBLE_EQ(mass.prior->value, 0.3);
  EXPECT_DOUBLE_EQ(mass.prior->spread, 2e-3);
  EXPECT_DOUBLE_EQ(parse_free_entry("Friction coefficient=0.3+-0.02").prior->spread, 0.02);
  EXPECT_FALSE(parse_free_entry("Motion/Grip torque").prior);
  EXPECT_EQ(parse_gyroscope_zero("0").spread, 0);
  EXPECT_DOUBLE_EQ(parse_start("1200 +- 50 ms").value, 1.2);
  EXPECT_EQ(parse_start("1.2").spread, 0);
  EXPECT_THROW(parse_start("1.2 m"), BadInput);
  for (const char *bad : { "Motion/Mass = 0.3", "Motion/Mass = 0.3 ± x", "Motion/Closure", "Motion/Mas" })
    EXPECT_THROW(parse_free_entry(bad), BadInput) << bad;
}

TEST(Fit, RunsThatCannotBeFittedAreRefused)
{
  RunToFit run = { "run.csv", study_of({}), {} };
  run.data.times = { 0, 1, 2 };
  run.data.values = { 0, -1, -2 };
  EXPECT_THAT(test::sentence_of([&] { fit_friction_and_grip({ run }); }), testing::HasSubstr("3 points"));
  run.data.times = { 0, 0.1, 0.2, 0.3, 0.4, 0.5 };
  run.data.values = { 0, 1, 2, 2.5, 2.8, 3 };
  EXPECT_THAT(test::sentence_of([&] { fit_friction_and_grip({ run }); }),
              testing::HasSubstr("the other way"));
}

} // namespace
} // namespace stemware::pipeline
