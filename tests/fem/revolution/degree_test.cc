#include "fem/contact/rigid_foot.h"
#include "fem/revolution/meshed_revolution_foot.h"
#include "ring_model/load/constants.h"
#include "tests/fem/revolution/revolution_case.h"
#include "tests/ulps.h"

#include <gtest/gtest.h>

using stemware::ring::pi;
using namespace stemware::revolution_tests;

namespace
{

class EveryDegree : public testing::TestWithParam<unsigned int>
{
protected:
  /// Returns the compliance for the harmonics 0 and 1 only, for tests that do not depend on elasticity.
  ContactCompliance compliance(const GlassProfile &profile, const MeridianResolution &resolution) const
  {
    return foot_compliance(profile, resolution, { GetParam(), 1 });
  }
};

INSTANTIATE_TEST_SUITE_P(Degree, EveryDegree, testing::Values(1u, 2u, 3u, 4u),
                         [](const auto &info) { return std::to_string(info.param); });

} // namespace

TEST_P(EveryDegree, LinesCoverTheLandOnceAndHaveTheGapOfTheProfile)
{
  const GlassProfile profile;
  const RevolutionCase foot(profile, compliance(profile, graded_cells()), 64);
  const ContactSurface &surface = foot.body.contact_surface();
  const double inner = profile.land_inner_radius();
  const double outer = profile.land_outer_radius();
  EXPECT_NEAR(surface.node_area.sum() / (pi * (outer * outer - inner * inner)), 1, 1e-12);

  for (const ContactLine &line : surface.lines)
    for (unsigned int sample = 0; sample < 3; ++sample)
    {
      EXPECT_NEAR(line.gap(sample), profile.gap(line.position.row(sample).norm()),
                  stemware::ulps(100, profile.crown_radius));
      EXPECT_NEAR(line.shape.row(sample).sum(), 1, 1e-13);
    }
}

TEST_P(EveryDegree, FlatLandOnAMatHasUniformPressure)
{
  GlassProfile profile = flat_profile();
  const RevolutionCase foot(profile, compliance(profile, equal_cells()), 64);
  const ContactSurface &surface = foot.body.contact_surface();
  RigidFoot rigid(surface);
  const auto mat = make_law(WinklerInterface(1e10), surface);
  const ContactSolution solution = solve_contact(rigid, *mat, load_at(0), profile.contact_radius);
  const double area = surface.node_area.sum();
  for (unsigned int i = 0; i < surface.n_nodes(); ++i)
    EXPECT_NEAR(solution.forces(i), weight * surface.node_area(i) / area, 1e-12 * weight);
}

TEST_P(EveryDegree, SecondHarmonicDueToFrictionAgreesWithCalculiX)
{
  RevolutionSetup setup;
  setup.profile = flat_profile();
  setup.table.interface = std::make_shared<WinklerInterface>(1e11);
  setup.friction_coefficient = 0.3;
  setup.meridian.degree = GetParam();
  setup.meridian.n_harmonics = 4;
  setup.resolution.refinements = GetParam() == 1 ? 2 : 0;
  MeshedRevolutionFoot foot(setup.resolved_for(weight));
  const ContactLoad load = foot.solve(load_at(0.4)).load;
  EXPECT_NEAR(load.a(2) / load.a(0) / 1.43e-2, 1, 0.01); // 1.43e-2: CalculiX
}
