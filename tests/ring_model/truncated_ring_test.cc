#include "ring_model/self_consistent_ring.h"
#include "ring_model/unilateral_foundation.h"
#include "tests/ring_model/reference.h"

#include <cmath>
#include <stdexcept>

namespace stemware::ring
{
namespace
{
using test::expect_relative;

SelfConsistentRing truncated_ring(double exponent, unsigned int n_max, const Motion &motion = {})
{
  return SelfConsistentRing(Closure::full, motion, std::make_shared<UnilateralFoundation>(0.03, exponent),
                            n_max);
}

TEST(TruncatedRing, FirstHarmonicAloneIsTheFormalFirstHarmonic)
{
  // Whatever the foundation, M_N alone decides the first harmonic; docs/theory/closures.md has the value.
  for (const double exponent : { 1., 1.5 })
    expect_relative(test::terminal_spin_of(truncated_ring(exponent, 1)).omega, -3.67874799852576, 1e-13,
                    "omega");
  for (const double omega : { 0., -3., 8., -40. })
  {
    const RingEquilibrium state = truncated_ring(1.5, 1).at(omega);
    EXPECT_NEAR(state.friction.torque, SelfConsistentRing(Closure::full, Motion(), 0.03).torque(omega),
                1e-16);
    EXPECT_EQ(state.load.n_harmonics(), 1u);
  }
}

TEST(TruncatedRing, FrictionActsBackOnTheMoment)
{
  // Lift-off (z_CM = 0.10 m): the second harmonic adds friction across the motion, T_y = mu (a_1 P_1 + a_2
  // P_2
  // + ...), which the balance of moments answers with another b_1. Cutting off the load of all harmonics
  // leaves that b_1 as it is; both must agree with their own balance only.
  Motion motion;
  motion.centre_of_mass_height = 0.10;
  const double omega = -4.;
  const RingEquilibrium whole = truncated_ring(1., 64, motion).at(omega);
  const RingEquilibrium two = truncated_ring(1., 2, motion).at(omega);
  EXPECT_GT(std::abs(two.load.b(1) - whole.load.b(1)) / whole.load.a(0), 1e-5);
  const auto imbalance = [&](const RingStack &load)
  {
    const Wrench friction = coulomb_wrench(motion.friction_coefficient, load, omega, motion.orbit_speed);
    return (required_moment(Closure::full, motion, { friction.force_x, friction.force_y }) - load.moment())
             .norm() /
           (motion.normal_force() * 0.03);
  };
  EXPECT_LT(imbalance(two.load), 1e-13);
  EXPECT_GT(imbalance(whole.load.truncated(2)), 1e-6);
}

TEST(TruncatedRing, SpinsApproachThatOfAllHarmonics)
{
  Motion motion;
  motion.centre_of_mass_height = 0.10;
  const double all = test::terminal_spin_of(truncated_ring(1., 128, motion), motion).omega;
  expect_relative(all, -5.026328, 2e-7, "all harmonics"); // docs/theory/closures.md
  double last = 1;
  for (const unsigned int n : { 2u, 4u, 8u, 16u })
  {
    const double change =
      std::abs(test::terminal_spin_of(truncated_ring(1., n, motion), motion).omega / all - 1);
    EXPECT_LT(change, last / 2) << n;
    last = change;
  }
}

TEST(TruncatedRing, RefusesToDropTheMoment)
{
  EXPECT_THROW(truncated_ring(1., 0), std::invalid_argument);
}
} // namespace
} // namespace stemware::ring
