#include "ring_model/failures.h"
#include "ring_model/friction_functionals.h"
#include "tests/benchmark/random_study.h"
#include "tests/fem/pipeline/analysis/solved_study.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <vector>

namespace stemware::pipeline
{
namespace
{

/// Compares the bound with the torque of the omitted harmonics (`rest`) at 33 spins up to the terminal spin.
/// Adds bound / rest to @p ratios if `rest` exceeds 1e-9 of the torque scale.
void compare_bounds(const test::SolvedStudy &solved, std::vector<double> &ratios)
{
  const ring::Motion &motion = solved.study.motion.orbit;
  const double scale = motion.friction_coefficient * motion.normal_force() * solved.load.radius();
  for (int i = 1; i <= 33; ++i)
  {
    const double omega = solved.omega() * i / 33;
    const ring::TorqueByHarmonics torque(motion, solved.load.at(omega), omega);
    for (const unsigned int n : { 1u, 2u, 3u, 4u, 6u, 8u })
    {
      const double rest = std::abs(torque.rest(n)), rounding = 1e-14 * scale;
      EXPECT_GE(torque.bound(n) + rounding, rest) << "omega " << omega << ", n " << n;
      if (rest > 1e-9 * scale)
        ratios.push_back(torque.bound(n) / rest);
    }
  }
}

/// Compares the bounds with the torques of the first @p n_studies random studies of @p seed that have a
/// terminal spin.
void compare_bounds_of_studies(unsigned int n_studies, unsigned int seed)
{
  RandomStudies random(seed);
  std::vector<double> ratios;
  unsigned int n_compared = 0, n_tipping = 0;
  while (n_compared < n_studies)
  {
    ASSERT_LE(n_tipping, n_studies);
    SCOPED_TRACE("study " + std::to_string(n_compared + n_tipping + 1) + " of seed " + std::to_string(seed));
    const auto solved =
      ring::find_or_nullopt([&] { return std::make_unique<test::SolvedStudy>(random.next()); });
    if (!solved || !(*solved)->row.terminal)
    {
      ++n_tipping;
      continue;
    }
    compare_bounds(**solved, ratios);
    ++n_compared;
  }
  ASSERT_GT(ratios.size(), 30u * n_studies);
  const auto middle = ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2);
  std::nth_element(ratios.begin(), middle, ratios.end());
  std::printf("median of bound over rest: %.2f; %u glasses tip\n", *middle, n_tipping);
}

TEST(TorqueBound, ExceedsTheTorqueOfOmittedHarmonicsInFourStudies)
{
  compare_bounds_of_studies(4, 62);
}

TEST(TorqueBound, ExceedsTheTorqueOfOmittedHarmonicsInSixtyStudiesLong)
{
  compare_bounds_of_studies(60, 1);
}

} // namespace
} // namespace stemware::pipeline
