// Reference: an independent program, accurate to 1e-3 (relative).
#include "tests/fem/pipeline/analysis/solved_study.h"
#include "tests/fem/pipeline/mat_study.h"

#include <gtest/gtest.h>

#include <cmath>

namespace stemware::pipeline
{
namespace
{

using test::SolvedStudy;

Study hard_disc(double thickness, double young_modulus, double poisson_ratio)
{
  Study study = test::mat_study();
  study.glass.profile.shape = fem::GlassShape::step;
  study.motion.tilt = false;
  study.table.interface = TableInterface::hard;
  study.table.substrate = TableSubstrate::elastic;
  study.table.disc.radius = 0.15;
  study.table.disc.thickness = thickness;
  study.table.disc_material = { young_modulus, poisson_ratio };
  return study;
}

/// Terminal spin with friction that deforms neither body, the foot only, or both bodies.
struct ByFriction
{
  explicit ByFriction(Study study)
  {
    both = SolvedStudy(study).omega();
    Model without_substrate;
    without_substrate.friction_in_substrate = false;
    foot = SolvedStudy(study, without_substrate).omega();
    study.contact.friction_coupling = FrictionCoupling::none;
    neither = SolvedStudy(study).omega();
  }

  double neither, foot, both; ///< [rad/s]
};

TEST(RealTable, DeformationOfTheFootByFrictionSlowsTheGlassOnHardwood)
{
  Study study = hard_disc(0.05, 10e9, 0.3);
  const ByFriction spin(study);
  EXPECT_NEAR(spin.neither, -3.678, 1e-3 * 3.678);
  EXPECT_NEAR(spin.foot, -3.632, 1e-3 * 3.632);
  // Deformation of the wood by friction changes the spin by about 1e-4 (relative) only.
  EXPECT_GT(std::abs(spin.both / spin.foot - 1), 5e-5);
  EXPECT_LT(std::abs(spin.both / spin.foot - 1), 2e-4);

  study.motion.orbit.centre_of_mass_height = 0.10;
  const ByFriction higher(study);
  EXPECT_NEAR(higher.neither, -5.033, 1e-3 * 5.033);
  EXPECT_NEAR(higher.foot, -4.938, 1e-3 * 4.938);
}

TEST(RealTable, DeformationOfCorkByFrictionHardlyChangesTheSpin)
{
  const ByFriction spin(hard_disc(0.005, 5e6, 0));
  EXPECT_NEAR(spin.foot, -3.667, 2e-3 * 3.667);
  EXPECT_NEAR(spin.both, -3.675, 2e-3 * 3.675);
  EXPECT_NEAR(spin.both - spin.foot, -0.008, 0.003);
}

} // namespace
} // namespace stemware::pipeline
