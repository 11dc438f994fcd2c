#include "ring_model/load/constants.h"
#include "tests/fem/revolution/revolution_case.h"
#include "tests/verification/calculix_foot.h"

#include <gtest/gtest.h>

#include <vector>

using stemware::ring::pi;
using namespace stemware::revolution_tests;

namespace
{

ContactLoad solve(unsigned int refinements, unsigned int degree)
{
  const GlassProfile profile;
  RevolutionCase foot(profile, foot_compliance(profile, graded_cells(refinements), { degree, 8 }));
  return foot.solve_on_winkler(1e10, load_at(1.2));
}

double order_of(const ContactLoad &one, const ContactLoad &halved, const ContactLoad &quartered)
{
  const auto value = [](const ContactLoad &load) { return load.a(2) / load.a(0); };
  return std::log2((value(one) - value(halved)) / (value(halved) - value(quartered)));
}

/// Returns the smallest exponent lambda of the displacement r^lambda at a free re-entrant corner of 270
/// degrees, sin(3 pi lambda / 2) = lambda (Williams 1952): 0.5445.
double exponent_of_the_corner()
{
  double below = 0.5, above = 0.6;
  for (int i = 0; i < 60; ++i)
  {
    const double middle = (below + above) / 2;
    (std::sin(1.5 * pi * middle) > middle ? below : above) = middle;
  }
  return below;
}

double distance_from_calculix(const ContactLoad &load)
{
  double largest = -1;
  for (const auto &expected : stemware::verification::CalculixFoot("crown").loads)
    if (expected.modulus == 1e10 && expected.moment_ratio == 1.2)
      for (unsigned int n = 2; n <= 6; ++n)
        largest = std::max(largest, std::abs(load.a(n) / load.a(0) - expected.a[n]));
  EXPECT_GE(largest, 0) << "the reference has no such load";
  return largest;
}

} // namespace

TEST(Convergence, HarmonicsConvergeToCalculiXAndCornersLimitTheOrder)
{
  // At the re-entrant corners of the step profile, stresses vary like r^(lambda - 1). On fine meshes of any
  // degree, the harmonics therefore converge like h^(2 lambda).
  std::vector<std::vector<ContactLoad>> loads;
  for (const unsigned int degree : { 1u, 2u, 3u })
    loads.push_back({ solve(0, degree), solve(1, degree), solve(2, degree) });
  loads.push_back({ solve(0, 4), solve(1, 4) });

  const double order_of_corners = 2 * exponent_of_the_corner();
  EXPECT_NEAR(order_of_corners, 1.089, 1e-3);
  for (const unsigned int p : { 1u, 2u })
  {
    const double order = order_of(loads[p - 1][0], loads[p - 1][1], loads[p - 1][2]);
    EXPECT_GT(order, order_of_corners) << "degree " << p;
    EXPECT_LT(order, 2 * p) << "degree " << p; // order without re-entrant corners
  }
  EXPECT_NEAR(order_of(loads[2][0], loads[2][1], loads[2][2]), order_of_corners, 0.05);
  const ContactLoad &finest = loads[3][1];
  // The mesh error of CalculiX is 2e-5.
  EXPECT_LT(distance_from_calculix(finest), 3e-5);
  EXPECT_LT(distance_from_calculix(loads[1][0]), 6e-5);
  EXPECT_LT(distance_from_calculix(loads[0][0]), 5e-4);
  EXPECT_GT(distance_from_calculix(loads[0][0]), 3 * distance_from_calculix(finest));
  for (unsigned int p = 1; p < 3; ++p)
    EXPECT_LT(largest_difference(loads[p + 1][0], loads[p][1]),
              0.3 * largest_difference(loads[p][0], loads[p][1]))
      << "degree " << p + 1;
}
