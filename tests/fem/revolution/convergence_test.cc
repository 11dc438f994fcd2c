// Self-convergence of the harmonics in mesh, order, number of harmonics and of azimuth lines.
#include "revolution_case.h"

#include <gtest/gtest.h>

using namespace stemware::revolution_tests;

namespace
{

LoadHarmonics press(unsigned int refinements, unsigned int degree, unsigned int n_harmonics = 16,
                    unsigned int n_lines = 256, double m = 1.2)
{
  const GlassProfile profile;
  RevolutionCase foot(
    profile, foot_compliance(profile, graded_cells(refinements), { degree, n_harmonics, 0 }), n_lines);
  return foot.press_on_mat(1e10, load_at(m));
}

/// Largest difference of a_n / a_0, n = 2 ... 8.
double difference(const LoadHarmonics &one, const LoadHarmonics &other)
{
  double largest = 0;
  for (unsigned int n = 2; n <= 8; ++n)
    largest = std::max(largest, std::abs(one.a[n] / one.a[0] - other.a[n] / other.a[0]));
  return largest;
}

} // namespace

TEST(Convergence, OfMeshAndOrder)
{
  const LoadHarmonics finest = press(1, 4, 8);
  const double linear = difference(press(1, 1, 8), finest);
  const double quadratic = difference(press(0, 2, 8), finest);
  const double finer = difference(press(1, 2, 8), finest);
  const double cubic = difference(press(0, 3, 8), finest);
  EXPECT_LT(quadratic, 3e-5);
  EXPECT_LT(finer, quadratic / 1.8); // the corners of the step profile bound the rate
  EXPECT_LT(cubic, quadratic);
  EXPECT_GT(linear, quadratic);
}

TEST(Convergence, OfHarmonicsAndLines)
{
  const LoadHarmonics finest = press(0, 2, 32, 1024, 1.5);
  EXPECT_LT(difference(press(0, 2, 8, 1024, 1.5), finest), 1e-5);
  EXPECT_LT(difference(press(0, 2, 16, 1024, 1.5), finest), 1e-6);
  EXPECT_LT(difference(press(0, 2, 32, 256, 1.5), finest), 1e-5);
  EXPECT_LT(difference(press(0, 2, 32, 512, 1.5), finest), 2e-6);
}
