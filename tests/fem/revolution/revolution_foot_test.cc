#include "fem/contact/hard_interface.h"
#include "fem/revolution/meshed_revolution_foot.h"
#include "ring_model/load/constants.h"
#include "tests/fem/revolution/revolution_case.h"
#include "tests/ulps.h"

#include <gtest/gtest.h>

using stemware::ring::pi;
using namespace stemware::revolution_tests;

/// Reference: Hertz ellipse with the semi-axes b and k b under the force P, for radii of curvature R_x
/// (across) and R_y (along). R_y / R_x = (k^2 E - K) / (K - E) and b^3 = 3 P E R' / (pi k E*), with 1 / R' =
/// 1 / R_x + 1 / R_y, the plane-strain modulus E* and the complete elliptic integrals K and E.
TEST(HardTable, CrestWidthAgreesWithHertzAndExpectedWidthIsAGeometricMean)
{
  constexpr double slenderness = 300;
  constexpr int n_points = 100000;
  double first = 0, second = 0; // complete elliptic integrals K, E
  for (int i = 0; i < n_points; ++i)
  {
    const double angle = (i + 0.5) / n_points * pi / 2;
    const double root = std::sqrt(std::pow(std::cos(angle), 2) + std::pow(std::sin(angle) / slenderness, 2));
    first += pi / 2 / n_points / root;
    second += pi / 2 / n_points * root;
  }
  const double across = 0.003;
  const double along = across * (slenderness * slenderness * second - first) / (first - second);
  RevolutionSetup setup;
  setup.table.interface = std::make_shared<HardInterface>();
  EXPECT_EQ(crest_half_width(setup, weight), 0);
  setup.imperfection.glass = { { 3, 0.6 * 0.03 * 0.03 / along / 9, 0.1 } };
  setup.imperfection.table = { { 5, 0.8 * 0.03 * 0.03 / along / 25, 0 } };
  const double compliance = (1 - 0.22 * 0.22) / 70e9;
  const double cube =
    // 3 P is the weight, because each of the three crests bears a third of it.
    weight * second * compliance / (pi * slenderness * (1 / across + 1 / along));
  EXPECT_NEAR(crest_half_width(setup, weight) / std::cbrt(cube), 1, 1e-6);
  const double even = hertz_half_width(setup, weight), crest = crest_half_width(setup, weight);
  EXPECT_GT(crest, even);
  EXPECT_NEAR(expected_half_width(setup, weight) / std::sqrt(even * crest), 1, 1e-12);
}

TEST(RevolutionFoot, WarmAndColdStartsAgreeAndARepeatedSolveTakesOneStep)
{
  const RevolutionSetup setup;
  const MeshedRevolutionFoot warm(setup);
  std::optional<ContactState> before;
  for (const double m : { 0.3, 0.6, 1.25, 1.6 })
  {
    MeshedRevolutionFoot cold(setup);
    const ContactState from_rest = cold.solve(load_at(m, 2 * m));
    const ContactState from_before = warm.solve(load_at(m, 2 * m), {}, { before ? &*before : nullptr });
    before = from_before;
    const ContactLoad &expected = from_rest.load;
    const ContactLoad &load = from_before.load;
    for (unsigned int n = 0; n <= 8; ++n)
    {
      EXPECT_NEAR(load.a(n), expected.a(n), 1e-9 * expected.a(0));
      EXPECT_NEAR(load.b(n), expected.b(n), 1e-9 * expected.a(0));
    }
  }
  EXPECT_EQ(warm.solve(load_at(1.6, 3.2), {}, { &*before }).solution.n_iterations, 1u);
  EXPECT_GT(MeshedRevolutionFoot(setup).solve(load_at(1.6, 3.2)).solution.n_iterations, 1u);
}

TEST(Imperfection, PutsTheCrestsAtTheGivenAzimuths)
{
  const RimImperfection rim = { { { 3, 2e-6, 0.4 } }, {} };
  for (const unsigned int crest : { 0u, 1u, 2u })
  {
    EXPECT_NEAR(rim.gap(1, 0.4 + 2 * pi * crest / 3, 0, 0), 2e-6, stemware::ulps(30, 2e-6));
    EXPECT_NEAR(rim.gap(1, 0.4 + 2 * pi * (crest + 0.5) / 3, 0, 0), -2e-6, stemware::ulps(30, 2e-6));
  }
}

TEST(Imperfection, OffsetAndTiltOfTheTableDoNotChangeTheLoad)
{
  RevolutionSetup setup;
  MeshedRevolutionFoot perfect(setup);
  setup.imperfection.table = { { 0, 2e-4, 0 }, { 1, 1.1e-4, -0.46 } };
  MeshedRevolutionFoot tilted(setup);
  const ContactLoad expected = perfect.solve(load_at(1.1)).load;
  const ContactLoad load = tilted.solve(load_at(1.1), { 0, { 0.3, 0.7 } }).load;
  for (unsigned int n = 0; n <= 8; ++n)
  {
    EXPECT_NEAR(load.a(n), expected.a(n), 1e-9 * expected.a(0));
    EXPECT_NEAR(load.b(n), expected.b(n), 1e-9 * expected.a(0));
  }
}

TEST(Imperfection, RotatesWithGlassAndTable)
{
  RevolutionSetup setup;
  setup.imperfection.glass = { { 2, 3e-7, 0 } };
  MeshedRevolutionFoot glass(setup);
  setup.imperfection.table = { { 2, 3e-7, 0 } };
  setup.imperfection.glass.clear();
  MeshedRevolutionFoot table(setup);
  const double angle = 2 * pi * 21 / 256;
  const ContactLoad still = glass.solve(load_at(0.4)).load;
  EXPECT_GT(std::abs(still.a(2) / still.a(0)), 1e-3);
  const ContactLoad turned = glass.solve(load_at(0.4, angle), { 0, { angle, 0 } }).load;
  EXPECT_NEAR(turned.a(2), still.a(2) * std::cos(2 * angle) - still.b(2) * std::sin(2 * angle),
              1e-8 * still.a(0));
  EXPECT_NEAR(turned.b(2), still.a(2) * std::sin(2 * angle) + still.b(2) * std::cos(2 * angle),
              1e-8 * still.a(0));
  const ContactLoad below = table.solve(load_at(0.4, angle), { 0, { 0, angle } }).load;
  EXPECT_NEAR(below.a(2), turned.a(2), 1e-8 * still.a(0));
}

TEST(RevolutionFoot, StatesStayValidAfterTheNextSolve)
{
  // The rim is rotated between the two states.
  const std::shared_ptr<const InterfaceLaw> interfaces[] = { std::make_shared<WinklerInterface>(),
                                                             std::make_shared<HardInterface>() };
  for (const auto &interface : interfaces)
  {
    RevolutionSetup setup;
    setup.table.interface = interface;
    setup.imperfection.glass = { { 2, 3e-7, 0 } };
    setup.meridian.n_harmonics = 8;
    MeshedRevolutionFoot foot(setup.resolved_for(weight));
    const ContactState first = foot.solve(load_at(0.4), { 0, { 0.5, 0 } });
    const double peak = foot.pressure_map(first).cuts[3][4].pressure;
    const std::string fields = foot.fields(first).front().text;
    foot.solve(load_at(0.9, 1.), { 0, { 2., 0 } });
    const ContactLoad sums = harmonics_of(foot.point_forces(first), 4);
    for (unsigned int n = 0; n <= 4; ++n)
    {
      // The harmonics of point_forces() and of the nodal forces agree to the equilibrium tolerance.
      EXPECT_NEAR(sums.a(n), first.load.a(n), 1e-9 * first.load.a(0)) << n;
      EXPECT_NEAR(sums.b(n), first.load.b(n), 1e-9 * first.load.a(0)) << n;
    }
    EXPECT_EQ(foot.pressure_map(first).cuts[3][4].pressure, peak);
    EXPECT_EQ(foot.fields(first).front().text, fields);
  }
}
