// A foot a million times as stiff as glass against a rigid one, by plain sums over the points of its land,
// and that against the closed forms of a ring of no width (docs/theory/load_models.md).
#include "tests/fem/foot_case.h"
#include "tests/verification/plain_rigid_foot.h"

#include <gtest/gtest.h>

using namespace stemware::fem;
using namespace stemware::fem_tests;
using namespace stemware::verification;

namespace
{

const ElasticMaterial very_stiff{ 70e15, 0.22 };

struct RigidRing
{
  double moment_ratio;
  double a_over_a0[5]; ///< n = 2 ... 6
};

/// The harmonics of @p foot to 2e-5 of a_0, where most of the rim has lifted off to 2e-4, which the sectors
/// of its mesh leave; those of the ring of no width to @p of_width.
void expect_harmonics(FootCase &foot, const GlassProfile &profile, double modulus, const RigidRing &ring,
                      double of_width)
{
  PlainRigidFoot plain = PlainRigidFoot::on_mat(modulus);
  plain.inner_radius = profile.land_inner_radius();
  plain.outer_radius = profile.land_outer_radius();
  plain.crown_radius = profile.crown_radius;
  const Resultants demand = load_at(ring.moment_ratio);
  const std::vector<PlainPoint> points =
    plain.forces(plain.lie_under(weight, demand.moment_x, demand.moment_y, 1e-6));
  const ContactLoad load = foot.solve_on_winkler(modulus, demand);
  const double tolerance = ring.moment_ratio < 1.3 ? 2e-5 : 2e-4;
  for (unsigned int n = 2; n <= 6; ++n)
  {
    const double expected = harmonic_over_mean(points, n);
    EXPECT_NEAR(load.a(n) / load.a(0), expected, tolerance) << "m = " << ring.moment_ratio << ", n = " << n;
    EXPECT_NEAR(expected, ring.a_over_a0[n - 2], of_width) << "m = " << ring.moment_ratio << ", n = " << n;
  }
}

} // namespace

TEST(RigidLimit, FlatRingOnAMat)
{
  GlassProfile profile = flat_profile();
  profile.land_width = 0.0005;
  FootCase foot(profile, { 24, 2, 1 }, {}, very_stiff);
  for (const RigidRing &ring :
       { RigidRing{ 0.8, { 0, 0, 0, 0, 0 } },
         RigidRing{ 1.2, { 0.0962799669, -0.0686460157, 0.0394761682, -0.0146457969, -0.0020009154 } },
         RigidRing{ 1.5, { 0.5177741159, -0.0770927089, -0.0897805871, 0.0435211171, 0.0292202943 } },
         RigidRing{ 1.8, { 1.2846018580, 0.6615005787, 0.1518441150, -0.1162448349, -0.1505900663 } } })
    expect_harmonics(foot, profile, 1e10, ring, 1e-3);
}

TEST(RigidLimit, TorusRimOnAMat)
{
  FootCase foot(GlassProfile(), { 24, 4, 1 }, {}, very_stiff);
  for (const RigidRing &ring :
       { RigidRing{ 0.5, { 0.0216141997, -6.288813e-4, 4.133006e-5, -3.628702e-6, 3.721098e-7 } },
         RigidRing{ 1.2, { 6. / 35, -0.0190476190, 0.0051948052, -0.0019980020, 9.324009e-4 } },
         RigidRing{ 1.8, { 1.2888588420, 0.6808576241, 0.1945825053, -0.0566029311, -0.0965376371 } } })
    expect_harmonics(foot, GlassProfile(), 1e11, ring, 3e-4);
}
