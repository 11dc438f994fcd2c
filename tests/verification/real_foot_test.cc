#include "tests/fem/foot_case.h"
#include "tests/fem/geometry/profile_oracle.h"
#include "tests/fem/revolution/revolution_case.h"

#include <gtest/gtest.h>

namespace
{

using namespace stemware::revolution_tests;
using stemware::fem_tests::foot_profile;
using stemware::fem_tests::FootCase;

/// Returns the observed convergence order of a_2 ... a_4 with quadratic elements, from one halving.
/// Reference: cubic elements on the halved mesh.
double observed_order(const GlassProfile &profile)
{
  const auto solve = [&](unsigned int refinements, unsigned int degree)
  {
    RevolutionCase foot(profile, foot_compliance(profile, graded_cells(refinements), { degree, 8 }));
    return foot.solve_on_winkler(1e10, load_at(1.2));
  };
  const ContactLoad finest = solve(1, 3);
  return std::log2(largest_difference(solve(0, 2), finest, 4) / largest_difference(solve(1, 2), finest, 4));
}

} // namespace

TEST(RealFoot, HarmonicsConvergeFasterThanOnTheStep)
{
  // At the 270-degree corners of the step, the displacement varies like r^0.54 with the distance r.
  EXPECT_GT(observed_order(foot_profile()), 3.4);
  EXPECT_LT(observed_order(GlassProfile()), 2.2);
}

TEST(RealFoot, SolidBodyConvergesToTheBodyOfRevolution)
{
  GlassProfile profile = flat_profile();
  profile.shape = GlassShape::foot;
  RevolutionCase revolution(profile, foot_compliance(profile, equal_cells(1)));
  const Resultants load = load_at(1.3);
  const ContactLoad expected = revolution.solve_on_winkler(1e10, load);
  SolidOptions linear;
  linear.degree = 1;
  double before = 0;
  for (const unsigned int n : { 12u, 24u, 48u })
  {
    FootCase solid(profile, { n, n / 6, n / 12 }, linear);
    const ContactLoad answer = solid.solve_on_winkler(1e10, load);
    EXPECT_NEAR(answer.a(0) / expected.a(0), 1, 1e-10);
    EXPECT_NEAR(answer.moment().y() / expected.moment().y(), 1, 1e-9);
    const double now = largest_difference(answer, expected, 6);
    if (before > 0)
    {
      EXPECT_GT(std::log2(before / now), 1.6) << n << " trilinear cells round the rim";
    }
    before = now;
  }
  FootCase quadratic(profile, { 24, 4, 2 });
  EXPECT_LT(largest_difference(quadratic.solve_on_winkler(1e10, load), expected, 6), 1e-4);
}
