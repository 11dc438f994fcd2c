#include "ring_model/friction_functionals.h"
#include "ring_model/friction_kernels.h"
#include "tests/ring_model/quadrature.h"
#include "tests/ring_model/reference.h"

#include <boost/math/constants/constants.hpp>

#include <limits>
#include <stdexcept>

namespace stemware::ring
{
namespace
{
using test::expect_relative;
using test::reference;

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
    EXPECT_NEAR(wrench.torque, row["tau"].get<double>(), 1e-16);
    EXPECT_NEAR(wrench.force_x, row["T_par"].get<double>(), 2e-15);
    EXPECT_NEAR(wrench.force_y, row["T_perp"].get<double>(), 2e-15);
    expect_relative(-(wrench.force_x * speed + wrench.torque * omega),
                    row["dissipation_over_v"].get<double>() * speed, 1e-13, "dissipation");
  }
}

TEST(CoulombRing, QuadratureAgreesWithKernels)
{
  const RingStack load = reference_load();
  // Geometric convergence away from |eps| = 1 (N for 1e-15: docs/theory/kernels.md), algebraic at it.
  for (const auto &[eps, n_points, tolerance] : { std::tuple{ 0.1, 64u, 1e-15 },
                                                  { -0.5, 128u, 1e-15 },
                                                  { 0.9, 600u, 2e-15 },
                                                  { 5., 64u, 1e-15 },
                                                  { 1., 4000u, 2e-7 } })
  {
    const Wrench exact = coulomb_wrench(0.3, load, eps * 0.35 / 0.03, 0.35);
    const Wrench sum = test::wrench_by_quadrature(0.3, load, eps * 0.35 / 0.03, 0.35, n_points);
    EXPECT_NEAR(sum.torque, exact.torque, 0.03 * tolerance) << eps;
    EXPECT_NEAR(sum.force_x, exact.force_x, tolerance) << eps;
    EXPECT_NEAR(sum.force_y, exact.force_y, tolerance) << eps;
  }
}

TEST(CoulombRing, QuadratureErrsByTheAliasedKernels)
{
  // With N points half a cell off psi = 0 harmonic n errs by sum_j (-1)^j (K_{jN-n} + K_{jN+n}), exactly.
  const double eps = 0.6, mu = 0.3, R = 0.03;
  const unsigned int n_points = 20;
  const auto kernels = FrictionKernels(eps, 1., 110);
  for (const unsigned int n : { 0u, 4u })
  {
    std::vector<double> a(n + 1, 0.);
    a[0] = 1.;
    a[n] = 1.;
    const RingStack load(a, std::vector<double>(n + 1, 0.), R);
    double aliased = 0.;
    for (unsigned int j = 1; j <= 5; ++j)
    {
      const double sign = j % 2 == 0 ? 1. : -1.;
      aliased += sign * 2. * kernels.K(j * n_points);
      if (n > 0)
      {
        aliased += sign * (kernels.K(j * n_points - n) + kernels.K(j * n_points + n));
      }
    }
    const double error = test::wrench_by_quadrature(mu, load, eps * 0.35 / R, 0.35, n_points).torque -
                         coulomb_wrench(mu, load, eps * 0.35 / R, 0.35).torque;
    EXPECT_NEAR(error, mu * R * aliased, 1e-16) << n;
    EXPECT_GT(std::abs(error), 1e-8) << n;
  }
}

TEST(CoulombRing, QuadraturePointsForFullPrecisionAreThoseOfTheReference)
{
  // The least N with 2 |K_N| <= 1e-15 |K_0|: from K_n up to n = 240000. The reference solves an asymptotic
  // formula for N.
  const auto &table = reference()["trapezoid_points_for_1e-15"];
  for (std::size_t i = 0; i < table["eps"].size(); ++i)
  {
    const unsigned int expected = table["N_n0"][i], slack = 1 + expected / 2000;
    const auto kernels = FrictionKernels(table["eps"][i], 1., expected + slack);
    const auto error = [&](unsigned int n_points)
    { return 2. * kernels.K(n_points) / std::abs(kernels.K(0)); };
    EXPECT_LE(error(expected + slack), 1e-15) << table["eps"][i];
    EXPECT_GT(error(expected - slack - 1), 1e-15) << table["eps"][i];
  }
}

TEST(CoulombRing, NeverGivesEnergyToANonnegativeLoad)
{
  test::Numbers numbers(7);
  for (unsigned int trial = 0; trial < 3000; ++trial)
  {
    const auto [a, b] = numbers.nonnegative_load(1 + trial % 20);
    const RingStack load(a, b, numbers.between(0.01, 0.1));
    const double speed = numbers.between(0., 1.), omega = std::sinh(numbers.between(-6., 6.));
    const Wrench wrench = coulomb_wrench(numbers.between(0., 1.), load, omega, speed);
    EXPECT_GE(-(wrench.force_x * speed + wrench.torque * omega), -1e-13 * speed);
  }
}

TEST(CoulombRing, OnlyTheFirstHarmonicActsAtRest)
{
  test::Numbers numbers(9);
  for (unsigned int trial = 0; trial < 100; ++trial)
  {
    const auto [a, b] = numbers.nonnegative_load(12);
    const RingStack load(a, b, 0.03);
    const Wrench wrench = coulomb_wrench(0.3, load, 0., 0.35);
    expect_relative(wrench.torque, 0.3 * load.moment().x(), 1e-14, "tau(0) = mu M_Nx");
    EXPECT_NEAR(wrench.force_x, -0.3 * load.normal_force(), 1e-14);
    EXPECT_EQ(wrench.force_y, 0.);
  }
}

TEST(CoulombRing, SmallSlipLawHoldsToSecondOrder)
{
  // tau = mu R pi [b_1 - eps (a_0 + a_2/2)] - mu R (3 pi/8) eps^2 (b_1 + b_3) + O(eps^3)
  const RingStack load = reference_load();
  const double mu = 0.3, R = load.radius(), pi = boost::math::constants::pi<double>();
  double previous = 0.;
  for (const double eps : { 0.02, 0.01, 0.005 })
  {
    const double law =
      mu * R * pi *
      (load.b(1) - eps * (load.a(0) + load.a(2) / 2.) - 3. / 8. * eps * eps * (load.b(1) + load.b(3)));
    const double error = std::abs(coulomb_wrench(mu, load, eps * 0.35 / R, 0.35).torque - law);
    if (previous > 0.)
    {
      EXPECT_NEAR(previous / error, 8., 0.3);
    }
    previous = error;
  }
}

TEST(CoulombRing, TruncationBoundHolds)
{
  test::Numbers numbers(10);
  for (unsigned int trial = 0; trial < 500; ++trial)
  {
    const auto [a, b] = numbers.nonnegative_load(16);
    const RingStack load(a, b, 0.03);
    const double omega = std::sinh(numbers.between(-4., 4.)), speed = 0.35;
    const double full = coulomb_wrench(0.3, load, omega, speed).torque;
    for (const unsigned int n_max : { 0u, 1u, 2u, 3u, 8u, 16u })
    {
      const double change = std::abs(coulomb_wrench(0.3, load.truncated(n_max), omega, speed).torque - full);
      const double bound = truncation_bound(Motion(), load, n_max, omega);
      EXPECT_LE(change, bound + 1e-16);
      if (n_max == 16)
      {
        EXPECT_EQ(bound, 0.);
      }
    }
  }
  // Sharp for a single harmonic that the torque sees, b_3.
  const RingStack single({ 1., 0., 0., 0. }, { 0., 0., 0., 0.2 }, 0.03);
  const double change =
    coulomb_wrench(0.3, single, 6., 0.35).torque - coulomb_wrench(0.3, single.truncated(2), 6., 0.35).torque;
  expect_relative(std::abs(change), truncation_bound(Motion(), single, 2, 6.), 1e-12, "sharp bound");
}

TEST(CoulombRing, PureSpinAndPureSlideAreOpposedFully)
{
  const RingStack load({ 1., 0.2 }, { 0., 0.3 }, 0.03);
  expect_relative(coulomb_wrench(0.4, load, 5., 0.).torque, -0.4 * load.normal_force() * 0.03, 1e-14, "spin");
  expect_relative(coulomb_wrench(0.4, load, 0., 2.).force_x, -0.4 * load.normal_force(), 1e-14, "slide");
}

TEST(CoulombRing, ThePrintedTorqueOfThePaperHasTheWrongSign)
{
  // - mu int lambda R (v sin - omega R) / |v_rel|, as printed, for the load of the paper's Fig. 3.
  const double mu = 0.3, R = 0.03, pi = boost::math::constants::pi<double>();
  const RingStack load = RingStack::first_harmonic(0.3 * 9.81, { -0.01225, 0. }, R);
  const auto printed = [&](double omega, double speed)
  {
    double sum = 0.;
    const unsigned int n_points = 64;
    for (unsigned int i = 0; i < n_points; ++i)
    {
      const double theta = 2. * pi * (i + 0.5) / n_points, rim = omega * R;
      const double slip = std::sqrt(speed * speed + rim * rim - 2. * speed * rim * std::sin(theta));
      sum -= mu * load(theta) * R * (speed * std::sin(theta) - rim) / slip * 2. * pi / n_points;
    }
    return sum;
  };
  expect_relative(printed(0., 0.35), 0.003675, 1e-13, "against the paper's own -0.003675");
  expect_relative(printed(2., 0.), mu * load.normal_force() * R, 1e-13, "friction that drives a spin");
  expect_relative(printed(2., 0.), 0.026487, 1e-13, "mu N R");
  for (const double omega : { -6., 0., 2. })
  {
    EXPECT_NEAR(printed(omega, 0.35), -coulomb_wrench(mu, load, omega, 0.35).torque, 1e-15);
  }
}

TEST(CoulombRing, RefusesBadInput)
{
  const RingStack load({ 1. }, { 0. }, 0.03);
  EXPECT_THROW(coulomb_wrench(-0.1, load, 1., 1.), std::invalid_argument);
  EXPECT_THROW(coulomb_wrench(std::numeric_limits<double>::quiet_NaN(), load, 1., 1.), std::invalid_argument);
  EXPECT_THROW(coulomb_wrench(0.3, load, 0., 0.), std::invalid_argument);
  EXPECT_THROW(coulomb_wrench(0.3, load, 1., -1.), std::invalid_argument);
}
} // namespace
} // namespace stemware::ring
