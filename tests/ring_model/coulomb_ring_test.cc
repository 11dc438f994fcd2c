#include "ring_model/friction_functionals.h"
#include "tests/ring_model/reference.h"
#include "tests/ulps.h"

#include <limits>
#include <stdexcept>

namespace stemware::ring
{
namespace
{

RingStack reference_load()
{
  const auto &general = reference()["general_wrench"];
  return { general["a"], general["b"], general["R"] };
}

TEST(CoulombRing, AgreesWithReferenceWrenches)
{
  const auto &general = reference()["general_wrench"];
  const RingStack load = reference_load();
  for (const auto &row : general["cases"])
  {
    const double speed = 0.35, omega = row["eps"].get<double>() * speed / load.radius();
    const Wrench wrench = coulomb_wrench(general["mu"], load, omega, speed);
    EXPECT_NEAR(wrench.torque, row["tau"].get<double>(), ulps(17, 0.028));
    EXPECT_NEAR(wrench.force_x, row["T_par"].get<double>(), ulps(10, 0.94));
    EXPECT_NEAR(wrench.force_y, row["T_perp"].get<double>(), ulps(10, 0.94));
    expect_relative(-(wrench.force_x * speed + wrench.torque * omega),
                    row["dissipation_over_v"].get<double>() * speed, 1e-13, "dissipation");
  }
}

TEST(CoulombRing, DissipatesEnergyUnderACompressiveLoad)
{
  test::Numbers numbers(7);
  for (unsigned int trial = 0; trial < 3000; ++trial)
  {
    const RingStack load = numbers.nonnegative_load(1 + trial % 20, numbers.between(0.01, 0.1));
    const double speed = numbers.between(0., 1.), omega = std::sinh(numbers.between(-6., 6.));
    const Wrench wrench = coulomb_wrench(numbers.between(0., 1.), load, omega, speed);
    EXPECT_GE(-(wrench.force_x * speed + wrench.torque * omega), -1e-13 * speed);
  }
}

TEST(CoulombRing, HigherHarmonicsDoNotChangeTheFrictionAtRest)
{
  test::Numbers numbers(9);
  for (unsigned int trial = 0; trial < 100; ++trial)
  {
    const RingStack load = numbers.nonnegative_load(12);
    const Wrench wrench = coulomb_wrench(0.3, load, 0., 0.35);
    expect_relative(wrench.torque, 0.3 * load.moment().x(), 1e-14, "tau(0) = mu M_Nx");
    EXPECT_NEAR(wrench.force_x, -0.3 * load.normal_force(), 1e-14);
    EXPECT_EQ(wrench.force_y, 0.);
  }
}

TEST(CoulombRing, TruncationErrorStaysBelowTheBoundAndEqualsItForASingleHarmonic)
{
  test::Numbers numbers(10);
  for (unsigned int trial = 0; trial < 500; ++trial)
  {
    const RingStack load = numbers.nonnegative_load(16);
    const double omega = std::sinh(numbers.between(-4., 4.)), speed = 0.35;
    const double full = coulomb_wrench(0.3, load, omega, speed).torque;
    for (const unsigned int n_max : { 0u, 1u, 2u, 3u, 8u, 16u })
    {
      const double change = std::abs(coulomb_wrench(0.3, load.truncated(n_max), omega, speed).torque - full);
      const double bound = TorqueByHarmonics(Motion(), load, omega).bound(n_max);
      EXPECT_LE(change, bound + ulps(8, full));
      if (n_max == 16)
      {
        EXPECT_EQ(bound, 0.);
      }
    }
  }
  // The bound is sharp for a load whose only harmonic is b_3.
  const RingStack single({ 1., 0., 0., 0. }, { 0., 0., 0., 0.2 }, 0.03);
  const double change =
    coulomb_wrench(0.3, single, 6., 0.35).torque - coulomb_wrench(0.3, single.truncated(2), 6., 0.35).torque;
  expect_relative(std::abs(change), TorqueByHarmonics(Motion(), single, 6.).bound(2), 1e-12, "sharp bound");
}

TEST(CoulombRing, OpposesPureSpinAndPureSlideWithMuN)
{
  const RingStack load({ 1., 0.2 }, { 0., 0.3 }, 0.03);
  expect_relative(coulomb_wrench(0.4, load, 5., 0.).torque, -0.4 * load.normal_force() * 0.03, 1e-14, "spin");
  expect_relative(coulomb_wrench(0.4, load, 0., 2.).force_x, -0.4 * load.normal_force(), 1e-14, "slide");
}

TEST(CoulombRing, RefusesInvalidCoefficientsAndVelocities)
{
  const RingStack load({ 1. }, { 0. }, 0.03);
  EXPECT_THROW(coulomb_wrench(-0.1, load, 1., 1.), std::invalid_argument);
  EXPECT_THROW(coulomb_wrench(std::numeric_limits<double>::quiet_NaN(), load, 1., 1.), std::invalid_argument);
  EXPECT_THROW(coulomb_wrench(0.3, load, 0., 0.), std::invalid_argument);
  EXPECT_THROW(coulomb_wrench(0.3, load, 1., -1.), std::invalid_argument);
}
} // namespace
} // namespace stemware::ring
