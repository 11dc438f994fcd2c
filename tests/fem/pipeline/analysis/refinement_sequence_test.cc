#include "fem/pipeline/analysis/refinement_study.h"
#include "tests/ulps.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

namespace stemware::pipeline
{
namespace
{

std::vector<double> algebraic(double limit, double constant, double order, unsigned int n_levels)
{
  std::vector<double> values;
  for (unsigned int level = 0; level < n_levels; ++level)
    values.push_back(limit + constant * std::exp2(-order * level));
  return values;
}

TEST(RefinementSequence, FindsTheOrderAndLimitOfAPowerLaw)
{
  for (const double order : { 0.6, 1., 1.09, 2., 3., 4.5 })
    for (const double constant : { 0.3, -0.02 })
    {
      const RefinementSequence judged =
        assess_convergence(algebraic(-3.1, constant, order, 3), AxisKind::cells, 0);
      ASSERT_TRUE(judged.order) << order;
      EXPECT_NEAR(*judged.order, order, 1e-9);
      EXPECT_NEAR(judged.limit, -3.1, 1e-12);
    }
}

TEST(RefinementSequence, BandIsTheGridConvergenceIndex)
{
  // The values 1 + sqrt(h) for h = 1, 1/2, 1/4 leave an error of 1/2 at the finest level. The safety factor
  // is 1.25.
  const RefinementSequence low = assess_convergence(algebraic(1, 1, 0.5 + 1e-9, 3), AxisKind::cells, 0);
  EXPECT_NEAR(low.bands.back(), 1.25 / 2, 1e-8);
  // Above first order, the error band is 1.25 times the last difference. Error bands of coarser levels also
  // include the distance from the finest value.
  const RefinementSequence second = assess_convergence(algebraic(1, 1, 2, 3), AxisKind::cells, 0);
  EXPECT_NEAR(second.bands.back(), 1.25 * 3 / 16, 1e-14);
  ASSERT_EQ(second.bands.size(), 3u);
  EXPECT_NEAR(second.bands[2], 1.25 * 3 / 16, 1e-14);
  EXPECT_NEAR(second.bands[1], (1 + 1.25) * 3 / 16, 1e-14);
  EXPECT_NEAR(second.bands[0], 15. / 16 + 1.25 * 3 / 16, 1e-14);
}

TEST(RefinementSequence, BandContainsTheErrorForMixedOrders)
{
  // Errors h^p (1 + e h^q) with the cell size h = 2^-level are typical of meshes with corners.
  std::mt19937 random(7);
  std::uniform_real_distribution<double> order(0.8, 4), further(0.5, 2), mixing(-0.5, 0.5);
  for (unsigned int i = 0; i < 1000; ++i)
  {
    const double p = order(random), q = further(random), e = mixing(random);
    std::vector<double> values;
    for (unsigned int level = 0; level < 3; ++level)
      values.push_back(2 + std::exp2(-p * level) * (1 + e * std::exp2(-q * level)));
    const RefinementSequence judged = assess_convergence(values, AxisKind::cells, 0);
    for (unsigned int level = 0; level < 3; ++level)
      EXPECT_LE(std::abs(values[level] - 2), judged.bands[level])
        << "p = " << p << ", q = " << q << ", e = " << e;
  }
}

TEST(RefinementSequence, GivesAWideBandAndNoOrderForNonMonotoneValues)
{
  const RefinementSequence judged = assess_convergence({ 1, 1.2, 1.19 }, AxisKind::cells, 0);
  EXPECT_FALSE(judged.order);
  EXPECT_EQ(judged.limit, 1.19);
  EXPECT_NEAR(judged.bands.back(), 3 * 0.2, 1e-14);
}

TEST(RefinementSequence, GivesAWideBandAndNoOrderForImplausibleDifferences)
{
  // The first sequence converges slowly. The last difference of the second sequence is implausibly small.
  for (const std::vector<double> &values :
       { std::vector<double>{ 0, 1, 1.9 }, std::vector<double>{ 0, 1, 1 + 1e-6 } })
  {
    const RefinementSequence judged = assess_convergence(values, AxisKind::cells, 0);
    EXPECT_FALSE(judged.order);
    EXPECT_NEAR(judged.bands.back(), 3 * (values[2] - values[0]), 1e-12);
  }
}

TEST(RefinementSequence, GivesAWideBandAndNoOrderForDifferencesBelowRounding)
{
  const double rounding = 1e-9;
  const RefinementSequence judged =
    assess_convergence({ 1, 1 + 4e-10, 1 + 6e-10 }, AxisKind::cells, rounding);
  EXPECT_FALSE(judged.order);
  EXPECT_NEAR(judged.bands.back(), 3 * 6e-10 + rounding, ulps(5, 1));
}

TEST(RefinementSequence, BandAssumesFirstOrderForTwoLevels)
{
  const RefinementSequence judged = assess_convergence({ 1, 1.5 }, AxisKind::cells, 0);
  EXPECT_FALSE(judged.order);
  EXPECT_EQ(judged.limit, 1.5);
  EXPECT_NEAR(judged.bands.back(), 1.5 * 0.5, ulps(5, 1));
  EXPECT_NEAR(judged.bands[0], 2.5 * 0.5, ulps(5, 1));
}

TEST(RefinementSequence, BandOfADegreeSequenceIsComputedFromItsDifferences)
{
  const RefinementSequence judged = assess_convergence({ 1, 1.1, 1.11 }, AxisKind::degree, 0);
  EXPECT_FALSE(judged.order);
  EXPECT_EQ(judged.limit, 1.11);
  // The band uses the larger of the last difference and a quarter of the first difference.
  EXPECT_NEAR(judged.bands.back(), 1.25 * 0.1 / 4, 1e-14);
  const RefinementSequence slow = assess_convergence({ 1, 1.1, 1.15 }, AxisKind::degree, 0);
  EXPECT_NEAR(slow.bands.back(), 1.25 * 0.05, 1e-14);
  const RefinementSequence one = assess_convergence({ 2 }, AxisKind::degree, 1e-9);
  EXPECT_EQ(one.bands.back(), 1e-9);
}

TEST(RefinementSequence, RefusesEmptyAndInvalidSequences)
{
  EXPECT_THROW(assess_convergence({}, AxisKind::cells, 0), std::invalid_argument);
  EXPECT_THROW(assess_convergence({ 1, NAN }, AxisKind::degree, 0), std::invalid_argument);
}

} // namespace
} // namespace stemware::pipeline
