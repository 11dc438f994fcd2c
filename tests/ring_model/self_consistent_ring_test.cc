#include "ring_model/self_consistent_ring.h"
#include "tests/ring_model/reference.h"
#include "tests/ring_model/unilateral_rim.h"
#include "tests/ulps.h"

namespace stemware::ring
{
namespace
{

TEST(UnilateralRim, AgreesWithTheReferenceUnderTheFullClosure)
{
  for (const auto &row : reference()["closures_C_unilateral"]["cases"])
  {
    Motion motion;
    motion.centre_of_mass_height = row["zcm"];
    const test::UnilateralFoundation foundation(0.03, row["p"]);
    const test::BalancedRim rim{ Closure::full, motion, foundation };
    const TerminalSpin spin = test::terminal_spin_of(rim, motion);
    const auto rest = rim.at(0.), terminal = rim.at(spin.omega);
    const std::string name =
      "p " + std::to_string(row["p"].get<double>()) + " z_CM " + std::to_string(motion.centre_of_mass_height);
    const auto direction = [](const RingStack &load) { return std::atan2(load.b(1), load.a(1)); };

    expect_relative(rest.friction.torque, row["tau0"], 1e-13, name + " tau(0)");
    expect_relative(rest.moment_ratio, row["ratio0"], 1e-13, name + " m(0)");
    EXPECT_NEAR(direction(rest.load), row["beta0"].get<double>(), 1e-13) << name;
    expect_relative(foundation.edge(rest.moment_ratio), row["c0"], 1e-12, name + " c(0)");
    expect_relative(spin.omega, row["omega"], 1e-13, name + " omega");
    expect_relative(spin.omega * 0.03 / 0.35, row["eps"], 1e-13, name + " eps");
    expect_relative(terminal.moment_ratio, row["ratioT"], 1e-13, name + " m");
    EXPECT_NEAR(direction(terminal.load), row["betaT"].get<double>(), 1e-13) << name;
    expect_relative(foundation.edge(terminal.moment_ratio), row["cT"], 1e-12, name + " c");
    EXPECT_NEAR(terminal.friction.force_x, row["Tx"].get<double>(), 1e-13) << name;
    EXPECT_NEAR(terminal.friction.force_y, row["Ty"].get<double>(), 1e-13) << name;
    EXPECT_TRUE(spin.stable);
  }
}

TEST(SelfConsistentRing, BalancesMomentsAndIsMirroredByTheOppositeOrbitSense)
{
  for (const Closure closure : { Closure::paper, Closure::hand, Closure::full })
    for (const double omega : { 0., -4., 6., 15. })
    {
      Motion motion;
      motion.centre_of_mass_height = 0.09;
      const RingEquilibrium there = SelfConsistentRing(closure, motion, 0.03).at(omega);
      // Moment balance: M_N = -dz e_z x F + z e_z x T, with the moment M_N of the load, the friction force T
      // and the force F = m a - T of the hand. Closure::paper uses F = m a.
      const double dz = motion.force_offset, T_x = there.friction.force_x, T_y = there.friction.force_y;
      const double F_y = 0.3 * 0.35 * 0.35 / 0.15 - (closure == Closure::paper ? 0. : T_y);
      const double F_x = closure == Closure::paper ? 0. : -T_x;
      const double z = closure == Closure::full ? motion.centre_of_mass_height : 0.;
      EXPECT_NEAR(there.load.moment().x(), dz * F_y - z * T_y, 1e-14);
      EXPECT_NEAR(there.load.moment().y(), -dz * F_x + z * T_x, 1e-14);
      EXPECT_NEAR(there.friction.torque, coulomb_wrench(0.3, there.load, omega, 0.35).torque, 1e-13);

      motion.orbit_sense = OrbitSense::clockwise;
      const RingEquilibrium back = SelfConsistentRing(closure, motion, 0.03).at(-omega);
      EXPECT_NEAR(back.friction.torque, -there.friction.torque, ulps(170, 0.0265));
      EXPECT_NEAR(back.friction.force_x, there.friction.force_x, 1e-13);
      EXPECT_NEAR(back.friction.force_y, -there.friction.force_y, 1e-13);
      EXPECT_NEAR(back.load.b(1), -there.load.b(1), 1e-13);
    }
}

TEST(SelfConsistentRing, BalancesMomentsUnderStribecksLaw)
{
  Motion motion;
  motion.friction_law = FrictionLawKind::stribeck;
  motion.static_coefficient = 0.5;
  motion.friction_decay_speed = 0.2;
  for (const double omega : { 0., -3., 8., -40. })
  {
    const RingEquilibrium state = SelfConsistentRing(Closure::full, motion, 0.03).at(omega);
    const Wrench friction = wrench(motion, state.load, omega);
    const Eigen::Vector2d moment =
      required_moment(Closure::full, motion, { friction.force_x, friction.force_y });
    EXPECT_LE((moment - state.load.moment()).norm(), ulps(60, motion.normal_force() * 0.03)) << omega;
  }
}

TEST(UnilateralRim, UprightSlidingIsTheOnlyTerminalStateAndStableUnderACompressiveLoad)
{
  // Closed form for a hand at the height h of the centre of mass: -d tau / d(omega R / v) = mu N R (<cos^2> -
  // (mu h / R) <cos>) = mu N R Var(cos), with means <.> over the rim weighted by the load.
  Motion motion;
  motion.force_offset = 0.;
  motion.centre_of_mass_height = 0.09;
  const test::BalancedRim rim{ Closure::full, motion, test::UnilateralFoundation(0.03, 1.) };
  const auto spins = all_terminal_spins([&](double omega) { return rim.at(omega).friction.torque; },
                                        motion.yaw_inertia, 0.35 / 0.03, -30., 30., 60);
  ASSERT_EQ(spins.size(), 1u);
  EXPECT_NEAR(spins[0].omega, 0., 1e-10);
  EXPECT_TRUE(spins[0].stable);
  const RingStack load = rim.at(0.).load;
  const double mean = load.a(1) / (2. * load.a(0)), mean_square = 0.5 + load.a(2) / (4. * load.a(0));
  expect_relative(mean, 0.9, 1e-13, "<cos> = mu h / R");
  expect_relative(-spins[0].torque_slope * (0.35 / 0.03),
                  0.3 * motion.normal_force() * 0.03 * (mean_square - mean * mean), 1e-6, "damping");
}
} // namespace
} // namespace stemware::ring
