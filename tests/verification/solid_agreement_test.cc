// The two elastic bodies share law, driver and load extraction but neither mesh, element nor solver.
#include "tests/fem/foot_case.h"
#include "tests/fem/revolution/revolution_case.h"

#include <gtest/gtest.h>

namespace
{

using namespace stemware::revolution_tests;
using stemware::fem_tests::FootCase;

double difference_of_bodies(const ContactLoad &one, const ContactLoad &other)
{
  double largest = 0;
  for (unsigned int n = 2; n <= 6; ++n)
    largest = std::max(largest, std::abs(one.a(n) / one.a(0) - other.a(n) / other.a(0)));
  return largest;
}

} // namespace

TEST(SolidAgreement, DifferencesShrinkWithTheSolidMesh)
{
  const GlassProfile profile = flat_profile();
  RevolutionCase revolution(profile, foot_compliance(profile, equal_cells(1)));
  const Resultants load = load_at(1.3);
  const ContactLoad expected = revolution.solve_on_winkler(1e10, load);
  SolidOptions linear;
  linear.degree = 1;
  double before = 0;
  for (const unsigned int n : { 12u, 24u, 48u })
  {
    FootCase solid(profile, { n, n / 6, n / 12 }, linear);
    const double now = difference_of_bodies(solid.solve_on_winkler(1e10, load), expected);
    if (before > 0)
    {
      EXPECT_LT(now, before / 2) << n << " cells round the rim";
    }
    before = now;
  }
  FootCase quadratic(profile, { 24, 4, 2 });
  EXPECT_LT(difference_of_bodies(quadratic.solve_on_winkler(1e10, load), expected), 1e-3);
}
