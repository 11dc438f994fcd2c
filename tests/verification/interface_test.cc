#include "fem/contact/hard_interface.h"
#include "fem/contact/rough_interface.h"
#include "fem/revolution/compliance_cache.h"
#include "fem/revolution/meshed_revolution_foot.h"
#include "tests/fem/revolution/revolution_case.h"
#include "tests/verification/calculix_foot.h"
#include "tests/verification/plain_rigid_foot.h"

#include <gtest/gtest.h>

using namespace stemware::revolution_tests;
using namespace stemware::verification;

namespace
{

ContactLoad press_on(const RevolutionSetup &setup, const Resultants &load, double spin_per_speed = 0)
{
  return MeshedRevolutionFoot(setup.resolved_for(weight)).solve(load, { spin_per_speed, {} }).load;
}

} // namespace

// Under two of the four loads, part of the land lifts off. The pressure is singular at the inner edge of the
// land, where CalculiX has cells of 60 um. References above the sixth harmonic: the range of three other
// finite-element programs with nodal contact.
TEST(RigidTable, FlatLandWithAndWithoutLiftOffAgreesWithCalculiX)
{
  unsigned int n_compared = 0;
  for (const CalculixLoad &expected : CalculixFoot("flat").loads)
    if (!expected.modulus)
    {
      RevolutionSetup setup;
      setup.table.interface = std::make_shared<HardInterface>();
      setup.profile = flat_profile();
      setup.friction_coefficient = expected.friction;
      const ContactLoad load =
        press_on(setup, load_at(expected.moment_ratio, expected.direction), expected.spin_per_speed);
      for (unsigned int n = 1; n <= 6; ++n)
      {
        EXPECT_NEAR(load.a(n) / load.a(0), expected.a[n], 6e-4) << expected.name() << ", " << n;
        EXPECT_NEAR(load.b(n) / load.a(0), expected.b[n], 6e-4) << expected.name() << ", " << n;
      }
      if (expected.moment_ratio == 1.3)
      {
        EXPECT_NEAR(load.a(7) / load.a(0), -0.1415, 0.003);
        EXPECT_NEAR(load.a(8) / load.a(0), -0.0125, 0.003);
      }
      ++n_compared;
    }
  EXPECT_EQ(n_compared, 4u);
}

TEST(CompliantTable, RigidFootAgreesWithPlainQuadrature)
{
  const double modulus = 1e10, pressure_at_touch = 1e9, decay = 1e-6;
  PlainRigidFoot on_mat = PlainRigidFoot::on_mat(modulus), on_rough;
  on_rough.pulls_apart = false;
  on_rough.n_pieces = 20;
  on_rough.n_azimuths = 96;
  on_rough.pressure = [=](double depth) { return pressure_at_touch * std::exp(depth / decay); };
  const std::tuple<std::shared_ptr<const InterfaceLaw>, const PlainRigidFoot *, double> interfaces[] = {
    { std::make_shared<WinklerInterface>(modulus), &on_mat, 5e-6 },
    { std::make_shared<RoughInterface>(pressure_at_touch, decay), &on_rough, -1e-5 }
  };
  for (const auto &[interface, plain, depth] : interfaces)
    for (const double m : { 0.2775, 1.3 })
    {
      RevolutionSetup setup;
      setup.foot_is_rigid = true;
      setup.table.interface = interface;
      setup.n_lines = 128;
      const Resultants demand = load_at(m, 0.4);
      const ContactLoad load = press_on(setup, demand);
      const Eigen::Vector3d position = plain->position_under(weight, demand.moment_x, demand.moment_y, depth);
      const std::vector<PlainPoint> points = plain->forces(position);
      const double tolerance = m < 1 ? 2e-6 : 6e-6; // with lift-off, the contact ends between two lines
      for (unsigned int n = 1; n <= 6; ++n)
      {
        EXPECT_NEAR(load.a(n) / load.a(0), harmonic_over_mean(points, n), tolerance) << m << ", " << n;
        EXPECT_NEAR(load.b(n) / load.a(0), harmonic_over_mean(points, n, true), tolerance) << m << ", " << n;
      }
    }
}

// Dundurs: tangential tractions do not change the gap between two half-spaces of the same material. The
// displacements of harmonic 2 decay before they reach the stem or the bottom of the disc. The remaining
// coupling is a mesh error of the foot and decreases with refinement.
TEST(Friction, CouplingBetweenEqualHalfSpacesIsSmallAndDecreasesWithRefinement)
{
  const ElasticMaterial wood{ 10e9, 0.3 };
  GlassProfile profile = flat_profile();
  profile.foot_radius = profile.foot_thickness = 0.1;
  profile.land_height = 1e-5;
  profile.stem_radius = 0.027;
  TableDisc disc;
  disc.radius = disc.thickness = 0.1;
  double before = 0;
  for (const unsigned int refinements : { 2u, 3u })
  {
    MeridianResolution resolution = equal_cells(refinements);
    resolution.land_cells = 2;
    dealii::Triangulation<2> above, below;
    make_meridian_mesh(profile, resolution, above);
    make_meridian_mesh(disc, profile, resolution, below);
    const ContactCompliance of_foot = compute_compliance(above, wood, { 2, 2 });
    ContactCompliance of_both = of_foot;
    of_both += compute_compliance(below, wood, { 2, 2 });
    const double now = of_both.harmonics[2].azimuthal.norm() / of_foot.harmonics[2].azimuthal.norm();
    if (before > 0)
    {
      EXPECT_LT(now, 0.08);
      EXPECT_LT(now, before / 1.5);
    }
    before = now;
  }
}
