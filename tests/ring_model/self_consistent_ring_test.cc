#include "ring_model/first_harmonic_ring.h"
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
    const TerminalSpin spin = ring.terminal_spin();
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
    EXPECT_EQ(terminal.contact == ContactState::lift_off, row["cT"].get<double>() > -1.) << name;
  }
}

TEST(SelfConsistentRing, FirstHarmonicNeedsNoIteration)
{
  Motion motion;
  motion.orbit_acceleration = -0.3;
  for (const Closure closure : { Closure::paper, Closure::hand, Closure::full })
  {
    const SelfConsistentRing ring(closure, motion, std::make_shared<FirstHarmonicModel>(0.03));
    const FirstHarmonicRing closed_form(closure, motion, 0.03);
    for (const double omega : { 0., -3., 8., -40. })
    {
      const RingEquilibrium state = ring.at(omega);
      EXPECT_LE(state.n_evaluations, 2u);
      EXPECT_LE(state.moment_residual, 1e-14);
      EXPECT_NEAR(state.friction.torque, closed_form.torque(omega), 1e-16);
    }
  }
}

TEST(SelfConsistentRing, StartsFromABalanceNearby)
{
  const SelfConsistentRing ring(Closure::full, Motion(), std::make_shared<UnilateralFoundation>(0.03, 1.5));
  const RingEquilibrium nearby = ring.at(-3.6499), from_nothing = ring.at(-3.65);
  const RingEquilibrium from_nearby = ring.at(-3.65, &nearby.balance);
  EXPECT_NEAR(from_nearby.friction.torque, from_nothing.friction.torque, 1e-16);
  EXPECT_LT(from_nearby.n_evaluations, from_nothing.n_evaluations);
  // From its own result only the proof is left.
  EXPECT_EQ(ring.at(-3.65, &from_nothing.balance).n_evaluations, 1u);
}

TEST(SelfConsistentRing, ABadStartDoesNotMatter)
{
  const SelfConsistentRing ring(Closure::full, Motion(), std::make_shared<UnilateralFoundation>(0.03, 1.5));
  const RingEquilibrium expected = ring.at(-3.65);
  BalanceStart useless = expected.balance;
  useless.moment *= -1.2;
  useless.jacobian << 1e-3, 0., 0., -1e-3;
  EXPECT_NEAR(ring.at(-3.65, &useless).friction.torque, expected.friction.torque, 1e-16);
}

TEST(SelfConsistentRing, AsksNoMoreThanTheModelsAccuracy)
{
  /// Loads that are wrong by 1e-9, differently each time.
  class Noisy : public UnilateralFoundation
  {
  public:
    using UnilateralFoundation::UnilateralFoundation;
    RingStack rings(double normal_force, const Eigen::Vector2d &moment, const Slip &) const override
    {
      sign = -sign;
      return UnilateralFoundation::rings(normal_force, (1. + sign * 1e-9) * moment);
    }
    double accuracy() const override { return 1e-9; }

  private:
    mutable double sign = 1.;
  };
  const SelfConsistentRing noisy(Closure::full, Motion(), std::make_shared<Noisy>(0.03, 1.5));
  const SelfConsistentRing exact(Closure::full, Motion(), std::make_shared<UnilateralFoundation>(0.03, 1.5));
  const RingEquilibrium state = noisy.at(-3.65);
  EXPECT_LE(state.n_evaluations, 8u);
  EXPECT_NEAR(state.friction.torque, exact.at(-3.65).friction.torque, 1e-8 * 2.943 * 0.03);
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
        EXPECT_NEAR(there.hand_force.x(), -T_x, 1e-15);
        EXPECT_NEAR(there.friction.torque * omega + T_x * 0.35,
                    -CoulombRing(0.3).dissipation(there.load, omega, 0.35), 1e-13);

        motion.orbit_sense = OrbitSense::clockwise;
        const RingEquilibrium back = SelfConsistentRing(closure, motion, model).at(-omega);
        EXPECT_NEAR(back.friction.torque, -there.friction.torque, 1e-15);
        EXPECT_NEAR(back.friction.force_x, there.friction.force_x, 1e-13);
        EXPECT_NEAR(back.friction.force_y, -there.friction.force_y, 1e-13);
        EXPECT_NEAR(back.load.b(1), -there.load.b(1), 1e-13);
        EXPECT_NEAR(back.load.a(2), there.load.a(2), 1e-12);
      }
}

TEST(SelfConsistentRing, UprightSlidingIsStableForALoadThatOnlyPushes)
{
  // -d tau/d eps = mu N R (<cos^2> - (mu h/R) <cos>) = mu N R Var(cos) with the hand at the centre of mass.
  Motion motion;
  motion.force_offset = 0.;
  motion.centre_of_mass_height = 0.09;
  const SelfConsistentRing ring(Closure::full, motion, std::make_shared<UnilateralFoundation>(0.03, 1.));
  const auto spins = ring.terminal_spins(-30., 30., 60);
  ASSERT_EQ(spins.size(), 1u);
  EXPECT_NEAR(spins[0].omega, 0., 1e-10);
  EXPECT_TRUE(spins[0].stable);
  const RingStack load = ring.at(0.).load;
  const double mean = load.a(1) / (2. * load.a(0)), mean_square = 0.5 + load.a(2) / (4. * load.a(0));
  expect_relative(mean, 0.9, 1e-13, "<cos> = mu h / R");
  expect_relative(-spins[0].torque_slope * (0.35 / 0.03),
                  0.3 * motion.normal_force() * 0.03 * (mean_square - mean * mean), 1e-6, "damping");
}

TEST(SelfConsistentRing, NamesLiftOffAndTipping)
{
  Motion motion;
  motion.centre_of_mass_height = 0.10;
  const auto state = [&](std::shared_ptr<const LoadModel> model)
  { return SelfConsistentRing(Closure::full, motion, std::move(model)).at(0.).contact; };
  EXPECT_EQ(state(std::make_shared<FirstHarmonicModel>(0.03)), ContactState::lift_off);
  EXPECT_EQ(state(std::make_shared<UnilateralFoundation>(0.03, 1.)), ContactState::lift_off);
  EXPECT_EQ(state(std::make_shared<UnilateralFoundation>(0.03, 1.5)), ContactState::full_contact);
  motion.centre_of_mass_height = 0.17; // hand 0.12 m above the table: m = 2 mu h / R = 2.4
  EXPECT_EQ(state(std::make_shared<FirstHarmonicModel>(0.03)), ContactState::tipping);
  EXPECT_THROW(state(std::make_shared<UnilateralFoundation>(0.03, 1.)), Tipping);
  EXPECT_EQ(to_string(ContactState::lift_off), "lift-off");
}

TEST(SelfConsistentRing, KeepsAFixedLoad)
{
  const Motion motion;
  const RingStack load = UnilateralFoundation(0.03, 1.5).rings(
    motion.normal_force(), required_moment_at_rest(Closure::full, motion));
  const SelfConsistentRing ring(Closure::full, motion, std::make_shared<FixedLoad>(load));
  EXPECT_LE(ring.at(0.).moment_residual,
            1e-15); // frozen at rest, where the friction does not depend on the load
  EXPECT_GT(ring.at(-4.).moment_residual, 1e-3);
  EXPECT_NEAR(ring.terminal_spin().omega, terminal_spin(load, motion).omega, 1e-12);
  EXPECT_THROW(SelfConsistentRing(Closure::full, motion, nullptr), std::invalid_argument);
}
} // namespace
} // namespace stemware::ring
