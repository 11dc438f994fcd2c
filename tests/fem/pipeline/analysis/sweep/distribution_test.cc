// What --random takes, and the numbers that come out.
#include "fem/pipeline/analysis/sweep/swept_entry.h"
#include "fem/pipeline/support/failures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace stemware::pipeline
{
namespace
{

TEST(Spread, ReadsEveryKind)
{
  const Spread normal = parse_spread("Motion/Friction coefficient=0.3+-0.03");
  EXPECT_EQ(normal.path, "Motion/Friction coefficient");
  EXPECT_EQ(normal.description(), "normal, mean 0.3, standard deviation 0.03");
  EXPECT_EQ(parse_spread("A/B=0.3 ± 0.03").description(), normal.description());
  EXPECT_EQ(parse_spread("A/B=-0.05+-10%").description(), "normal, mean -0.05, standard deviation 0.005");
  EXPECT_EQ(parse_spread("A/B=1e-3+-1e-4").description(), "normal, mean 0.001, standard deviation 1e-4");
  EXPECT_EQ(parse_spread("A/B=1e10*/2").description(), "lognormal, median 1e10, factor 2");
  EXPECT_EQ(parse_spread("A/B=0.002..0.004").description(), "uniform, 0.002 to 0.004");
  EXPECT_EQ(parse_spread("A/B=-2..1").description(), "uniform, -2 to 1");
  EXPECT_EQ(parse_spread("A/B=1e9..1e11:log").description(), "uniform in the logarithm, 1e9 to 1e11");
}

TEST(Spread, QuantilesAreThoseOfTheBooks)
{
  // Standard normal: 97.5 % at 1.959963984540054, 84.1344746068543 % at 1 (Abramowitz & Stegun, table 26.1).
  constexpr double one_deviation = 0.841344746068543;
  const Spread normal = parse_spread("A/B=10+-2");
  EXPECT_NEAR(normal.quantile(0.5), 10, 1e-14);
  EXPECT_NEAR(normal.quantile(0.975), 10 + 2 * 1.959963984540054, 1e-13);
  EXPECT_NEAR(normal.quantile(1 - one_deviation), 8, 1e-12);
  const Spread lognormal = parse_spread("A/B=1e10*/2");
  EXPECT_NEAR(lognormal.quantile(0.5), 1e10, 1e-3);
  EXPECT_NEAR(lognormal.quantile(one_deviation), 2e10, 1e-1);
  EXPECT_NEAR(lognormal.quantile(1 - one_deviation), 5e9, 1e-1);
  EXPECT_DOUBLE_EQ(parse_spread("A/B=-2..2").quantile(0.25), -1);
  EXPECT_DOUBLE_EQ(parse_spread("A/B=1..100:log").quantile(0.5), 10);
}

TEST(Spread, SamplesHaveTheSpread)
{
  constexpr unsigned int n_samples = 20000;
  std::vector<Spread> spreads = { parse_spread("A/A=3+-0.5"), parse_spread("A/B=2..4") };
  const auto samples = draw_samples(spreads, n_samples, 7);
  ASSERT_EQ(samples.size(), n_samples);
  double sum[2] = {}, squares[2] = {}, product = 0;
  for (const auto &sample : samples)
  {
    for (unsigned int i = 0; i < 2; ++i)
    {
      sum[i] += (sample[i] - 3) / n_samples;
      squares[i] += (sample[i] - 3) * (sample[i] - 3) / n_samples;
    }
    product += (sample[0] - 3) * (sample[1] - 3) / n_samples;
  }
  // Four standard errors: deviation / sqrt(n) of a mean, about variance * sqrt(2/n) of a variance.
  EXPECT_NEAR(sum[0], 0, 4 * 0.5 / std::sqrt(n_samples));
  EXPECT_NEAR(sum[1], 0, 4 * std::sqrt(1. / 3 / n_samples));
  EXPECT_NEAR(squares[0], 0.25, 4 * 0.25 * std::sqrt(2. / n_samples));
  EXPECT_NEAR(squares[1], 1. / 3, 4 * 1. / 3 * std::sqrt(2. / n_samples));
  EXPECT_NEAR(product, 0, 4 * 0.5 * std::sqrt(1. / 3 / n_samples));
}

TEST(Spread, SamplesDependOnTheSeedAlone)
{
  const std::vector<Spread> spreads = { parse_spread("A/A=0..1"), parse_spread("A/B=1e10*/2") };
  const auto samples = draw_samples(spreads, 5, 42);
  EXPECT_EQ(draw_samples(spreads, 5, 42), samples);
  EXPECT_NE(draw_samples(spreads, 5, 43), samples);
  auto longer = draw_samples(spreads, 8, 42);
  longer.resize(5);
  EXPECT_EQ(longer, samples);
  // The twister's first output for the seed 42 is 13930160852258120406 (the reference implementation
  // mt19937-64.c).
  EXPECT_NEAR(samples[0][0], 13930160852258120406. / std::ldexp(1., 64), 1e-12);
}

class BadSpread : public testing::TestWithParam<const char *>
{
};

TEST_P(BadSpread, IsRefusedInOneSentence)
{
  try
  {
    parse_spread(GetParam());
    FAIL() << GetParam() << " was taken";
  }
  catch (const BadInput &refusal)
  {
    const std::string sentence = refusal.what();
    EXPECT_NE(sentence.find("--random \"" + std::string(GetParam()) + "\""), std::string::npos) << sentence;
    EXPECT_EQ(sentence.find('\n'), std::string::npos);
    EXPECT_EQ(sentence.back(), '.');
  }
}

INSTANTIATE_TEST_SUITE_P(All, BadSpread,
                         testing::Values("Friction=0.3+-0.1", "A/B", "A/B=", "A/B=0.3", "A/B=0.3+-",
                                         "A/B=0.3+-0", "A/B=0.3+--1", "A/B=0+-10%", "A/B=x+-1", "A/B=1e10*/1",
                                         "A/B=1e10*/0.5", "A/B=-1*/2", "A/B=4..2", "A/B=2..2", "A/B=0..2:log",
                                         "A/B=1..inf", "A/B=paper,hand", "A/B=1:2:3"));

} // namespace
} // namespace stemware::pipeline
