#include "ring_model/friction_functionals.h"
#include "tests/ring_model/quadrature.h"
#include "tests/ulps.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

namespace stemware::ring
{
namespace
{
/// Load of three rings; the second ring has a negative mean load. At 15 rad/s the slip ratio is below one on
/// the two inner rings and above one on the outer ring.
const RingStack load({ { 0.020, { 0.30, 0.05, -0.02, 0.01 }, { 0., 0.10, 0.03, -0.02 } },
                       { 0.022, { -0.10, 0.02, 0.01, 0.04 }, { 0., -0.06, 0.02, 0.03 } },
                       { 0.040, { 0.25, -0.07, 0.06, 0.02 }, { 0., 0.04, -0.05, 0.01 } } });
const std::vector<double> radii{ 0.020, 0.022, 0.040 };
const double speed = 0.35, mu = 0.3;

TEST(FrictionFunctionals, AgreeWithQuadrature)
{
  // The trapezoidal rule is exact to rounding at these slip ratios.
  for (const double omega : { -15., -3., 0., 4., 15., 60. })
  {
    const FrictionFunctionals friction = friction_functionals(coulomb_law(mu), radii, 3, omega, speed);
    const Wrench expected = test::wrench_by_quadrature(mu, load, omega, speed, 800);
    EXPECT_NEAR(friction.drag(load), expected.force_x, ulps(60, 0.8)) << omega;
    EXPECT_NEAR(friction.side(load), expected.force_y, ulps(60, 0.8)) << omega;
    EXPECT_NEAR(friction.torque(load), expected.torque, ulps(70, 0.02)) << omega;
  }
}

TEST(FrictionFunctionals, UseOnlyTheHarmonicsUpToTheGivenMaximum)
{
  const Wrench kept = coulomb_wrench(mu, load.truncated(1), 4., speed);
  const FrictionFunctionals friction = friction_functionals(coulomb_law(mu), radii, 1, 4., speed);
  EXPECT_EQ(friction.torque(load), kept.torque);
  EXPECT_EQ(friction.drag(load), kept.force_x);
  EXPECT_EQ(friction.side(load), kept.force_y);
  const FrictionFunctionals more = friction_functionals(coulomb_law(mu), radii, 9, 4., speed);
  EXPECT_NEAR(more.torque(load), coulomb_wrench(mu, load, 4., speed).torque, ulps(3, 0.02));
}

TEST(FrictionFunctionals, RefuseLoadsWithAnotherNumberOfRingsAndZeroVelocity)
{
  const FrictionFunctionals friction = friction_functionals(coulomb_law(mu), { 0.02, 0.04 }, 3, 4., speed);
  EXPECT_THROW(friction.torque(load), std::invalid_argument);
  EXPECT_THROW(friction_functionals(coulomb_law(mu), radii, 3, 0., 0.), std::invalid_argument);
}
} // namespace
} // namespace stemware::ring
