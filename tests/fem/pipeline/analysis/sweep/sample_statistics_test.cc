// Bands and sensitivities of samples whose answers are known in closed form.
#include "fem/pipeline/analysis/sweep/sweep_findings.h"

#include <boost/math/constants/constants.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace stemware::pipeline
{
namespace
{

/// Samples [input][sample] of independent inputs, uniform on (-1/2, 1/2) times the widths.
std::vector<std::vector<double>> uniform_inputs(const std::vector<double> &widths, unsigned int n_samples)
{
  std::vector<Spread> spreads;
  for (const double width : widths)
    spreads.push_back({ "A/B", Spread::Kind::uniform, -width / 2, width / 2 });
  std::vector<std::vector<double>> inputs(widths.size());
  for (const auto &sample : draw_samples(spreads, n_samples, 1))
    for (std::size_t i = 0; i < widths.size(); ++i)
      inputs[i].push_back(sample[i]);
  return inputs;
}

TEST(SampleStatistics, BandOfKnownValues)
{
  // 1 ... 81 in disorder: mean 41, variance n (n + 1) / 12, percentiles at places 1 + 0.025 * 80 = 3 and 79.
  std::vector<double> values;
  for (int i = 0; i < 81; ++i)
    values.push_back(1 + i * 32 % 81);
  const SampleBand band = band_of(values);
  EXPECT_DOUBLE_EQ(band.mean, 41);
  EXPECT_NEAR(band.deviation, std::sqrt(81 * 82 / 12.), 1e-13);
  EXPECT_DOUBLE_EQ(band.lower, 3);
  EXPECT_DOUBLE_EQ(band.upper, 79);
}

TEST(SampleStatistics, BandInterpolatesAndNeedsTwoValues)
{
  const SampleBand band = band_of({ 4, 0 });
  EXPECT_DOUBLE_EQ(band.lower, 0.1);
  EXPECT_DOUBLE_EQ(band.upper, 3.9);
  EXPECT_DOUBLE_EQ(band.deviation, std::sqrt(8.));
  EXPECT_THROW(band_of({ 1 }), std::invalid_argument);
}

TEST(SampleStatistics, LinearOutputIsExplainedToTheLastDigit)
{
  const auto inputs = uniform_inputs({ 1, 2, 4 }, 500);
  std::vector<double> output;
  for (std::size_t k = 0; k < 500; ++k)
    output.push_back(1e3 + 4 * inputs[0][k] - 3 * inputs[1][k] + inputs[2][k]);
  const auto sensitivity = sensitivity_of(inputs, output);
  ASSERT_TRUE(sensitivity);
  EXPECT_NEAR(sensitivity->r_squared, 1, 1e-12);
  const double deviation = band_of(output).deviation;
  EXPECT_NEAR(sensitivity->regression[0], 4 * band_of(inputs[0]).deviation / deviation, 1e-10);
  EXPECT_NEAR(sensitivity->regression[1], -3 * band_of(inputs[1]).deviation / deviation, 1e-10);
  EXPECT_NEAR(sensitivity->regression[2], band_of(inputs[2]).deviation / deviation, 1e-10);
}

TEST(SampleStatistics, FirstOrderSharesOfAnAdditiveOutputAddUpToOne)
{
  // Variances of the terms in the ratio 16 : 36 : 16 (coefficients times widths, squared).
  constexpr unsigned int n_samples = 10000;
  const auto inputs = uniform_inputs({ 1, 2, 4 }, n_samples);
  std::vector<double> output;
  for (std::size_t k = 0; k < n_samples; ++k)
    output.push_back(4 * inputs[0][k] - 3 * inputs[1][k] + inputs[2][k]);
  const auto sensitivity = sensitivity_of(inputs, output);
  ASSERT_TRUE(sensitivity);
  const double tolerance = 3 / std::sqrt(n_samples);
  EXPECT_NEAR(sensitivity->first_order[0], 16 / 68., tolerance);
  EXPECT_NEAR(sensitivity->first_order[1], 36 / 68., tolerance);
  EXPECT_NEAR(sensitivity->first_order[2], 16 / 68., tolerance);
  EXPECT_NEAR(sensitivity->first_order[0] + sensitivity->first_order[1] + sensitivity->first_order[2], 1,
              tolerance);
}

TEST(SampleStatistics, IshigamiFunction)
{
  // y = sin x1 + 7 sin^2 x2 + 0.1 x3^4 sin x1, x uniform on (-pi, pi): S = 0.3139, 0.4424, 0 (Ishigami &
  // Homma, ISUMA 1990; variances in closed form). No linear fit sees the second input.
  constexpr unsigned int n_samples = 20000;
  const double width = boost::math::constants::two_pi<double>();
  const auto inputs = uniform_inputs({ width, width, width }, n_samples);
  std::vector<double> output;
  for (std::size_t k = 0; k < n_samples; ++k)
    output.push_back(std::sin(inputs[0][k]) * (1 + 0.1 * std::pow(inputs[2][k], 4)) +
                     7 * std::pow(std::sin(inputs[1][k]), 2));
  const auto sensitivity = sensitivity_of(inputs, output);
  ASSERT_TRUE(sensitivity);
  const double tolerance = 3 / std::sqrt(n_samples);
  EXPECT_NEAR(sensitivity->first_order[0], 0.3139, tolerance);
  EXPECT_NEAR(sensitivity->first_order[1], 0.4424, tolerance);
  EXPECT_NEAR(sensitivity->first_order[2], 0, tolerance);
  EXPECT_NEAR(sensitivity->regression[1], 0, tolerance);
}

TEST(SampleStatistics, NothingCanBeSaidWithoutSpreadOrSamples)
{
  const std::vector<double> rising = { 1, 2, 3, 4 };
  EXPECT_TRUE(sensitivity_of({ rising }, { 1, 4, 2, 3 }));
  EXPECT_FALSE(sensitivity_of({ rising }, { 0.1, 0.1, 0.1, 0.1 }));
  EXPECT_FALSE(sensitivity_of({ { 5, 5, 5, 5 } }, rising));
  EXPECT_FALSE(sensitivity_of({ rising, rising, rising }, rising));
  EXPECT_FALSE(sensitivity_of({}, rising));
}

} // namespace
} // namespace stemware::pipeline
