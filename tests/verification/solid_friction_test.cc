// The solid foot applies the friction of the previous iteration as a given traction. In the body of
// revolution, the friction is part of the matrix.
#include "fem/contact/hard_interface.h"
#include "fem/contact/rough_interface.h"
#include "fem/revolution/meshed_revolution_foot.h"
#include "fem/solid/solid_foot.h"
#include "tests/fem/reference_load.h"
#include "tests/verification/calculix_foot.h"

#include <gtest/gtest.h>

using namespace stemware::fem_tests;

namespace
{

GlassProfile rounded_foot()
{
  GlassProfile profile;
  profile.shape = GlassShape::foot;
  return profile;
}

struct FrictionCase
{
  GlassProfile profile;
  std::shared_ptr<const InterfaceLaw> interface;
  double friction;
};

SolidFoot solid_foot(const FrictionCase &given, const FootResolution &resolution, LinearSolver solver)
{
  SolidSetup setup;
  setup.profile = given.profile;
  setup.table.interface = given.interface;
  setup.options.linear_solver = solver;
  setup.friction_coefficient = given.friction;
  return SolidFoot(generate_solid_mesh(given.profile, resolution), setup);
}

MeshedRevolutionFoot revolution_foot(const FrictionCase &given)
{
  RevolutionSetup setup;
  setup.profile = given.profile;
  setup.table.interface = given.interface;
  setup.friction_coefficient = given.friction;
  setup.meridian.n_harmonics = 16;
  setup.n_lines = 96;
  return MeshedRevolutionFoot(setup.resolved_for(weight));
}

} // namespace

TEST(SolidFriction, AgreesWithTheBodyOfRevolution)
{
  // The tolerance covers the discretisation errors. Friction changes a_2 / a_0 by 3e-3 to 3e-2.
  const auto mat = std::make_shared<WinklerInterface>(1e11);
  const struct
  {
    FrictionCase given;
    LinearSolver solver;
    double tolerance;
  } cases[] = {
    { { rounded_foot(), mat, 0.2 }, LinearSolver::multigrid, 2e-5 },
    { { rounded_foot(), mat, 0.6 }, LinearSolver::condensed, 2e-5 },
    { { rounded_foot(), std::make_shared<RoughInterface>(1e5, 1e-6), 0.2 }, LinearSolver::multigrid, 3e-5 },
    { { rounded_foot(), std::make_shared<HardInterface>(), 0.2 }, LinearSolver::multigrid, 1e-4 }
  };
  for (const auto &[given, solver, tolerance] : cases)
  {
    ContactDemand demand = load_at(0.8, 0.3);
    demand.n_harmonics = 8;
    demand.tilt_moment = 0.1 * weight; // with a tilt moment, the required moments depend on the tilt
    const stemware::ring::Slip slip = { -10, {} };
    const ContactState state = solid_foot(given, { 24, 2, 1, 1 }, solver).solve(demand, slip);
    const ContactState expected = revolution_foot(given).solve(demand, slip);
    EXPECT_LT(state.solution.equilibrium_residual, 1e-9);
    EXPECT_LT(state.solution.moment_residual, 1e-9);
    for (unsigned int n = 2; n <= 4; ++n)
    {
      const double a_0 = expected.load.a(0);
      EXPECT_NEAR(state.load.a(n) / a_0, expected.load.a(n) / a_0, tolerance) << n;
      EXPECT_NEAR(state.load.b(n) / a_0, expected.load.b(n) / a_0, tolerance) << n;
    }
  }
}

// Reference: CalculiX with the friction as a prescribed load (calculix_foot.py). On the mat, friction causes
// all of a_2, b_2, a_3 and b_3; on the hard table, half of them.
TEST(SolidFriction, AgreesWithCalculiX)
{
  unsigned int n_compared = 0;
  for (const auto &expected : stemware::verification::CalculixFoot("flat").loads)
    if (expected.spin_per_speed != 0)
    {
      std::shared_ptr<const InterfaceLaw> interface = std::make_shared<HardInterface>();
      if (expected.modulus)
        interface = std::make_shared<WinklerInterface>(*expected.modulus);
      ContactDemand demand = load_at(expected.moment_ratio, expected.direction);
      demand.n_harmonics = 8;
      const ContactLoad load =
        solid_foot({ flat_profile(), interface, expected.friction }, { 24, 2, 1, 1 }, LinearSolver::multigrid)
          .solve(demand, { expected.spin_per_speed, {} })
          .load;
      const double tolerance = expected.modulus ? 1e-4 : 2e-3;
      for (unsigned int n = 1; n <= 4; ++n)
      {
        EXPECT_NEAR(load.a(n) / load.a(0), expected.a[n], tolerance) << expected.name() << ", " << n;
        EXPECT_NEAR(load.b(n) / load.a(0), expected.b[n], tolerance) << expected.name() << ", " << n;
      }
      ++n_compared;
    }
  EXPECT_EQ(n_compared, 2u);
}
