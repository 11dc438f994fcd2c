#include "ring_model/friction_functionals.h"
#include "ring_model/load/constants.h"
#include "ring_model/self_consistent_ring.h"
#include "ring_model/terminal_spin.h"
#include "tests/ring_model/reference.h"
#include "tests/ring_model/unilateral_rim.h"

#include <cmath>
#include <stdexcept>
#include <vector>

namespace stemware::ring
{
namespace
{

/// Returns the terminal slip ratio for R = 1 m and v = 1 m/s. The load does not depend on the spin and drives
/// the ring counter-clockwise.
template <typename LoadOfMoment>
double terminal_slip_ratio(const LoadOfMoment &load, double moment_ratio)
{
  Motion motion;
  motion.orbit_speed = 1.;
  const double force = motion.normal_force();
  return terminal_spin(load(force, Eigen::Vector2d(0.5 * force * moment_ratio, 0.)), motion).omega;
}

TEST(TerminalSpin, AgreesWithTheReferenceUnderARadialLoad)
{
  const auto first_harmonic = [](double force, const Eigen::Vector2d &moment)
  { return RingStack::first_harmonic(force, moment, 1.); };
  const auto on = [](double exponent)
  {
    // The highest harmonic is negligible: the slip ratio is at most 0.966, and 0.966^1024 is below rounding.
    return [foundation = test::UnilateralFoundation(1., exponent, 1024)](double force, const auto &moment)
    { return foundation.rings(force, moment); };
  };
  for (const auto &row : reference()["terminal_radial_load"]["rows"])
  {
    const double m = row["ratio"];
    expect_relative(terminal_slip_ratio(first_harmonic, m), row["eps_first_harmonic"], 1e-13,
                    "first harmonic, m " + std::to_string(m));
    expect_relative(terminal_slip_ratio(on(1.), m), row["eps_p1.0"], 1e-13, "mat, m " + std::to_string(m));
    expect_relative(terminal_slip_ratio(on(1.5), m), row["eps_p1.5"], 1e-13, "torus, m " + std::to_string(m));
  }
}

TEST(TerminalSpin, BrakingTorqueAboveSlipRatioOneStaysAboveASharpLowerBound)
{
  // Fejer kernels are compressive loads close to a point force at any azimuth. Lower bound of the braking
  // torque: mu N R sqrt(1 - 1 / eps^2).
  constexpr unsigned int n_most = 400;
  constexpr double turn = 2 * ring::pi;
  const Motion motion;
  const double radius = 0.03, unit = motion.friction_at_rest() * motion.normal_force() * radius;
  double least = 1e9;
  for (const double eps : { 1.05, 1.5, -1.2 })
  {
    const double bound = std::sqrt(1 - 1 / (eps * eps));
    for (int place = 0; place < 90; ++place)
    {
      const double mean = motion.normal_force() / turn, theta = turn * place / 90;
      std::vector<double> a = { mean }, b = { 0 };
      for (unsigned int n = 1; n <= n_most; ++n)
      {
        const double amplitude = 2 * mean * (1 - n / (n_most + 1.));
        a.push_back(amplitude * std::cos(n * theta));
        b.push_back(amplitude * std::sin(n * theta));
      }
      const double omega = eps * motion.orbit_speed / radius;
      const double braking = -std::copysign(1., eps) * wrench(motion, RingStack(a, b, radius), omega).torque;
      EXPECT_GE(braking / unit, bound - 1e-9) << eps << ' ' << place;
      least = std::min(least, braking / unit / bound);
    }
  }
  EXPECT_LT(least, 1.05);
}

TEST(TerminalSpin, FindsAllRootsWithTheirStability)
{
  const auto torque = [](double omega) { return -(omega + 3.) * (omega - 1.) * (omega - 4.5); };
  const auto spins = all_terminal_spins(torque, 2., 10., -10., 10., 57);
  ASSERT_EQ(spins.size(), 3u);
  const double expected[3] = { -3., 1., 4.5 };
  for (unsigned int i = 0; i < 3; ++i)
  {
    expect_relative(spins[i].omega, expected[i], 1e-14, "root");
    EXPECT_EQ(spins[i].stable, i != 1);
  }
  expect_relative(spins[1].torque_slope, -(4. * -3.5), 1e-10, "slope");
  expect_relative(spins[1].time_constant, 2. / 14., 1e-10, "time constant");
}

TEST(TerminalSpin, FindsAPairOfRootsBetweenTwoSamples)
{
  const auto torque = [](double omega) { return (omega - 0.501) * (omega - 0.502); };
  const auto spins = all_terminal_spins(torque, 1., 10., -10., 10., 100);
  ASSERT_EQ(spins.size(), 2u);
  expect_relative(spins[0].omega, 0.501, 1e-12, "stable root");
  expect_relative(spins[1].omega, 0.502, 1e-12, "unstable root");
  EXPECT_TRUE(spins[0].stable);
  EXPECT_FALSE(spins[1].stable);
}

TEST(TerminalSpin, ReportsARootAtASamplePointOnce)
{
  const auto torque = [](double omega) { return -omega * (omega - 10.) * (omega + 10.); };
  const auto spins = all_terminal_spins(torque, 1., 10., -10., 10., 100);
  ASSERT_EQ(spins.size(), 3u);
  EXPECT_EQ(spins[1].omega, 0.);
  EXPECT_FALSE(spins[1].stable);
}

TEST(TerminalSpin, UprightSlidingIsUnstableBetweenTwoStableSpinsUnderAPartlyTensileLoad)
{
  // With the hand at the height h of the centre of mass, the damping in units of mu N R is 1/2 - (mu h/R)^2
  // under the first harmonic, negative for mu h/R > 1/sqrt 2. Under a compressive load, the damping is a
  // load-weighted variance, <cos^2> - <cos>^2 >= 0 (docs/theory/closures.md).
  Motion motion;
  motion.force_offset = 0.;
  motion.centre_of_mass_height = 0.09; // mu h / R = 0.9
  const SelfConsistentRing ring(Closure::full, motion, 0.03);
  const auto spins = all_terminal_spins([&](double omega) { return ring.torque(omega); }, motion.yaw_inertia,
                                        0.35 / 0.03, -35., 35., 401);
  ASSERT_EQ(spins.size(), 3u);
  EXPECT_NEAR(spins[1].omega, 0., 1e-12);
  EXPECT_FALSE(spins[1].stable);
  EXPECT_TRUE(spins[0].stable && spins[2].stable);
  expect_relative(spins[0].omega, -spins[2].omega, 1e-12, "mirror images");
  const double damping = -spins[1].torque_slope * (0.35 / 0.03) / (0.3 * motion.normal_force() * 0.03);
  expect_relative(damping, 0.5 - 0.9 * 0.9, 1e-6, "damping");
}

TEST(TerminalSpin, DoesNotExistWithoutATorqueZeroAndInvalidArgumentsAreRefused)
{
  EXPECT_THROW(terminal_spin([](double) { return 1.; }, 1., { 1. }), std::runtime_error);
  EXPECT_TRUE(all_terminal_spins([](double) { return 1.; }, 1., 1., -1., 1.).empty());
  EXPECT_THROW(terminal_spin([](double omega) { return -omega; }, 0., { 1. }), std::invalid_argument);
  EXPECT_THROW(all_terminal_spins([](double omega) { return -omega; }, 1., 1., 1., 1.),
               std::invalid_argument);
}
} // namespace
} // namespace stemware::ring
