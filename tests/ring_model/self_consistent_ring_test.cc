#include "ring_model/self_consistent_ring.h"
#include "ring_model/unilateral_foundation.h"
#include "tests/ring_model/reference.h"

#include <stdexcept>

namespace stemware::ring
{
namespace
{
using test::expect_relative;
using test::reference;

TEST(SelfConsistentRing, UnilateralRowsOfTheReference)
{
  for (const auto &row : reference()["closures_C_unilateral"]["cases"])
  {
    Motion motion;
    motion.centre_of_mass_height = row["zcm"];
    const auto foundation = std::make_shared<UnilateralFoundation>(0.03, row["p"].get<double>());
    const SelfConsistentRing ring(Closure::full, motion, foundation);
    const TerminalSpin spin = test::terminal_spin_of(ring, motion);
    const RingEquilibrium rest = ring.at(0.), terminal = ring.at(spin.omega);
    const std::string name =
      "p " + std::to_string(row["p"].get<double>()) + " z_CM " + std::to_string(motion.centre_of_mass_height);
    const auto direction = [](const RingStack &load) { return std::atan2(load.b(1), load.a(1)); };

    expect_relative(rest.friction.torque, row["tau0"], 1e-13, name + " tau(0)");
    expect_relative(rest.moment_ratio, row["ratio0"], 1e-13, name + " m(0)");
    EXPECT_NEAR(direction(rest.load), row["beta0"].get<double>(), 1e-13) << name;
    expect_relative(foundation->edge(rest.moment_ratio), row["c0"], 1e-12, name + " c(0)");
    expect_relative(spin.omega, row["omega"], 1e-13, name + " omega");
    expect_relative(spin.omega * 0.03 / 0.35, row["eps"], 1e-13, name + " eps");
    expect_relative(terminal.moment_ratio, row["ratioT"], 1e-13, name + " m");
    EXPECT_NEAR(direction(terminal.load), row["betaT"].get<double>(), 1e-13) << name;
    expect_relative(foundation->edge(terminal.moment_ratio), row["cT"], 1e-12, name + " c");
    EXPECT_NEAR(terminal.friction.force_x, row["Tx"].get<double>(), 1e-13) << name;
    EXPECT_NEAR(terminal.friction.force_y, row["Ty"].get<double>(), 1e-13) << name;
    EXPECT_TRUE(spin.stable);
    EXPECT_LE(terminal.n_evaluations, 8u) << name;
  }
}

TEST(SelfConsistentRing, FirstHarmonicTakesOneStep)
{
  Motion motion;
  motion.orbit_acceleration = -0.3;
  for (const Closure closure : { Closure::paper, Closure::hand, Closure::full })
  {
    const SelfConsistentRing ring(closure, motion, 0.03);
    for (const double omega : { 0., -3., 8., -40. })
    {
      const RingEquilibrium state = ring.at(omega);
      EXPECT_LE(state.n_evaluations, 2u);
      EXPECT_LE(state.moment_residual, 1e-14);
    }
  }
}

TEST(SelfConsistentRing, BalancesEverythingForAnyModelInBothSenses)
{
  const std::vector<std::shared_ptr<const LoadModel>> models{
    std::make_shared<FirstHarmonicModel>(0.03), std::make_shared<UnilateralFoundation>(0.03, 1.),
    std::make_shared<UnilateralFoundation>(0.03, 1.5, 32),
    std::make_shared<UnilateralFoundation>(0.03, 2., 16)
  };
  for (const auto &model : models)
    for (const Closure closure : { Closure::paper, Closure::hand, Closure::full })
      for (const double omega : { 0., -4., 6., 15. })
      {
        Motion motion;
        motion.centre_of_mass_height = 0.09;
        const RingEquilibrium there = SelfConsistentRing(closure, motion, model).at(omega);
        EXPECT_LE(there.moment_residual, 1e-13);
        // Written out once more: M_N = -Delta z k x F + z_CM k x T of the closure, with F = m a - T.
        const double dz = motion.force_offset, T_x = there.friction.force_x, T_y = there.friction.force_y;
        const double F_y = 0.3 * 0.35 * 0.35 / 0.15 - (closure == Closure::paper ? 0. : T_y);
        const double F_x = closure == Closure::paper ? 0. : -T_x;
        const double z = closure == Closure::full ? motion.centre_of_mass_height : 0.;
        EXPECT_NEAR(there.load.moment().x(), dz * F_y - z * T_y, 1e-14);
        EXPECT_NEAR(there.load.moment().y(), -dz * F_x + z * T_x, 1e-14);
        EXPECT_NEAR(there.friction.torque, coulomb_wrench(0.3, there.load, omega, 0.35).torque, 1e-13);

        motion.orbit_sense = OrbitSense::clockwise;
        const RingEquilibrium back = SelfConsistentRing(closure, motion, model).at(-omega);
        EXPECT_NEAR(back.friction.torque, -there.friction.torque, 1e-15);
        EXPECT_NEAR(back.friction.force_x, there.friction.force_x, 1e-13);
        EXPECT_NEAR(back.friction.force_y, -there.friction.force_y, 1e-13);
        EXPECT_NEAR(back.load.b(1), -there.load.b(1), 1e-13);
        EXPECT_NEAR(back.load.a(2), there.load.a(2), 1e-12);
      }
}

// Moments beyond the limit of tipping come up on the way: steps towards them are shortened.
TEST(SelfConsistentRing, BalancesAGlassThatNearlyTips)
{
  Motion motion;
  motion.friction_coefficient = 0.5431;
  motion.orbit_speed = 0.9353;
  motion.force_offset = -0.0735;
  motion.centre_of_mass_height = 0.1315;
  motion.orbit_radius = 0.1214;
  const double omega = -38.26;
  const auto model = std::make_shared<UnilateralFoundation>(0.03, 1.907, 32);
  const RingEquilibrium there = SelfConsistentRing(Closure::full, motion, model).at(omega);
  const double T_x = there.friction.force_x, T_y = there.friction.force_y, z = motion.centre_of_mass_height;
  const double F_y = 0.3 * 0.9353 * 0.9353 / 0.1214 - T_y;
  EXPECT_NEAR(there.load.moment().x(), -0.0735 * F_y - z * T_y, 1e-13);
  EXPECT_NEAR(there.load.moment().y(), -0.0735 * T_x + z * T_x, 1e-13);
  EXPECT_GT(there.load.moment().norm(), 1.95 * there.load.normal_force() * 0.03 / 2.);
}

TEST(SelfConsistentRing, UprightSlidingIsStableForALoadThatOnlyPushes)
{
  // -d tau/d eps = mu N R (<cos^2> - (mu h/R) <cos>) = mu N R Var(cos) with the hand at the centre of mass.
  Motion motion;
  motion.force_offset = 0.;
  motion.centre_of_mass_height = 0.09;
  const SelfConsistentRing ring(Closure::full, motion, std::make_shared<UnilateralFoundation>(0.03, 1.));
  const auto spins = all_terminal_spins([&](double omega) { return ring.torque(omega); }, motion.yaw_inertia,
                                        0.35 / 0.03, -30., 30., 60);
  ASSERT_EQ(spins.size(), 1u);
  EXPECT_NEAR(spins[0].omega, 0., 1e-10);
  EXPECT_TRUE(spins[0].stable);
  const RingStack load = ring.at(0.).load;
  const double mean = load.a(1) / (2. * load.a(0)), mean_square = 0.5 + load.a(2) / (4. * load.a(0));
  expect_relative(mean, 0.9, 1e-13, "<cos> = mu h / R");
  expect_relative(-spins[0].torque_slope * (0.35 / 0.03),
                  0.3 * motion.normal_force() * 0.03 * (mean_square - mean * mean), 1e-6, "damping");
}

TEST(SelfConsistentRing, TipsUnlessTheLoadMayPull)
{
  Motion motion;
  motion.centre_of_mass_height = 0.17; // hand 0.12 m above the table: m = 2 mu h / R = 2.4
  const auto at_rest = [&](std::shared_ptr<const LoadModel> model)
  { return SelfConsistentRing(Closure::full, motion, std::move(model)).at(0.); };
  EXPECT_GT(at_rest(std::make_shared<FirstHarmonicModel>(0.03)).moment_ratio, 2.);
  EXPECT_THROW(at_rest(std::make_shared<UnilateralFoundation>(0.03, 1.)), Tipping);
}

TEST(SelfConsistentRing, NeedsAModel)
{
  EXPECT_THROW(SelfConsistentRing(Closure::full, Motion(), nullptr), std::invalid_argument);
}
} // namespace
} // namespace stemware::ring
