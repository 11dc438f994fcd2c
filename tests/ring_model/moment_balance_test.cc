#include "ring_model/moment_balance.h"
#include "ring_model/self_consistent_ring.h"
#include "tests/ring_model/reference.h"
#include "tests/ulps.h"

#include <limits>
#include <stdexcept>

namespace stemware::ring
{
namespace
{

Closure closure_of(const nlohmann::json &row)
{
  return row["closure"] == "A" ? Closure::paper : row["closure"] == "B" ? Closure::hand : Closure::full;
}

Motion motion_of(const nlohmann::json &row)
{
  Motion motion;
  motion.gravity = row["g"];
  motion.centre_of_mass_height = row.value("zcm", 0.08);
  return motion;
}

TEST(Closures, AgreeWithTheReferenceForTheFirstHarmonic)
{
  for (const auto &row : reference()["closures_first_harmonic"])
  {
    const Motion motion = motion_of(row);
    const SelfConsistentRing ring(closure_of(row), motion, 0.03);
    const TerminalSpin spin = test::terminal_spin_of(ring, motion);
    const std::string name = row["closure"].get<std::string>() + " g " + std::to_string(motion.gravity) +
                             " z_CM " + std::to_string(motion.centre_of_mass_height);
    expect_relative(spin.omega, row["omega_T"], 1e-13, name + " omega");
    expect_relative(spin.omega * 0.03 / 0.35, row["eps_T"], 1e-13, name + " eps");
    expect_relative(spin.torque_slope, row["dtau_domega_T"], 1e-6, name + " slope");
    EXPECT_TRUE(spin.stable);
    expect_relative(spin.time_constant, motion.yaw_inertia / -row["dtau_domega_T"].get<double>(), 1e-6, name);
    for (const auto &[suffix, omega] : { std::pair{ "_0", 0. }, { "_T", spin.omega } })
    {
      const RingStack load = ring.at(omega).load;
      const Wrench wrench = ring.at(omega).friction;
      const std::string at = suffix;
      expect_relative(load.moment_ratio(load.radius()), row["ratio" + at], 2e-13, name + " m" + at);
      EXPECT_NEAR(load.a(1) / load.a(0), row["a1_over_a0" + at].get<double>(), 1e-13) << name;
      EXPECT_NEAR(load.b(1) / load.a(0), row["b1_over_a0" + at].get<double>(), 1e-13) << name;
      EXPECT_NEAR(wrench.force_x, row["T_par" + at].get<double>(), 1e-13) << name;
      EXPECT_NEAR(wrench.force_y, row["T_perp" + at].get<double>(), 1e-13) << name;
    }
    expect_relative(ring.torque(0.), row["tau_0"], 1e-14, name + " tau(0)");
    EXPECT_EQ(ring.at(0.).load.minimum() < 0. || ring.at(spin.omega).load.minimum() < 0.,
              row["formal_negative_load"].get<bool>())
      << name;
  }
}

TEST(Closures, ReproduceTheTorqueCurveOfThePaper)
{
  const SelfConsistentRing ring(Closure::paper, Motion(), 0.03);
  const auto &curve = reference()["torque_curve_A"];
  for (std::size_t i = 0; i < curve["omega"].size(); ++i)
    expect_relative(ring.torque(curve["omega"][i]), curve["tau"][i], 1e-13, "tau");
}

TEST(Closures, ReversedOrbitMirrorsLoadsWrenchesAndTheTerminalSpin)
{
  for (const Closure closure : { Closure::paper, Closure::hand, Closure::full })
  {
    Motion motion;
    const SelfConsistentRing there(closure, motion, 0.03);
    motion.orbit_sense = OrbitSense::clockwise;
    const SelfConsistentRing back(closure, motion, 0.03);
    EXPECT_EQ(test::terminal_spin_of(back, motion).omega, -test::terminal_spin_of(there).omega);
    for (const double omega : { 0., 3., -8., 20. })
    {
      const RingStack load = there.at(omega).load, mirror = back.at(-omega).load;
      const Wrench wrench = there.at(omega).friction, reversed = back.at(-omega).friction;
      EXPECT_EQ(mirror.a(1), load.a(1));
      EXPECT_EQ(mirror.b(1), -load.b(1));
      EXPECT_EQ(reversed.torque, -wrench.torque);
      EXPECT_EQ(reversed.force_x, wrench.force_x);
      EXPECT_EQ(reversed.force_y, -wrench.force_y);
    }
    // Closed form: tau(0) = mu dz m rho phidot |phidot| with the offset dz of the hand, the orbit radius rho
    // and the orbit rate phidot.
    expect_relative(back.torque(0.), 0.003675, 1e-14, to_string(closure));
  }
}

TEST(Closures, BalanceTheMomentsAboutTheCentreOfMass)
{
  Motion motion;
  motion.orbit_acceleration = 0.4;
  for (const OrbitSense sense : { OrbitSense::counterclockwise, OrbitSense::clockwise })
  {
    motion.orbit_sense = sense;
    const double towards_centre = sense == OrbitSense::counterclockwise ? 1. : -1.;
    const double T[3] = { -0.7, 0.2, 0. };
    const double F[3] = { motion.mass * 0.4 - T[0], motion.mass * towards_centre * 0.35 * 0.35 / 0.15 - T[1],
                          0. };
    const double hand[3] = { 0., 0., motion.force_offset },
                 table[3] = { 0., 0., -motion.centre_of_mass_height };
    const auto cross_x = [](const double *r, const double *f) { return r[1] * f[2] - r[2] * f[1]; };
    const auto cross_y = [](const double *r, const double *f) { return r[2] * f[0] - r[0] * f[2]; };
    const Eigen::Vector2d moment = required_moment(Closure::full, motion, { T[0], T[1] });
    EXPECT_NEAR(moment.x() + cross_x(hand, F) + cross_x(table, T), 0., ulps(7, 0.07));
    EXPECT_NEAR(moment.y() + cross_y(hand, F) + cross_y(table, T), 0., ulps(7, 0.07));
    const Eigen::Vector2d without_friction = required_moment(Closure::hand, motion, { T[0], T[1] });
    EXPECT_NEAR(without_friction.x() + cross_x(hand, F), 0., ulps(7, 0.07));
    EXPECT_NEAR(without_friction.y() + cross_y(hand, F), 0., ulps(7, 0.07));
  }
}

TEST(Closures, HandMomentAgreesWithTheReferenceAndExceedsTheLiftOffLimit)
{
  const auto &check = reference()["paper_liftoff_check"];
  const Motion motion;
  const Eigen::Vector2d paper = required_moment_at_rest(Closure::paper, motion);
  const Eigen::Vector2d hand = required_moment_at_rest(Closure::hand, motion);
  const double limit = 0.5 * motion.normal_force() * 0.03;
  expect_relative(paper.norm(), check["Mh_radial_part"], 1e-14, "radial part");
  expect_relative(std::abs(hand.y()), check["Mh_tangential_part"], 1e-14, "tangential part");
  expect_relative(hand.norm(), check["Mh_total"], 1e-14, "whole moment");
  expect_relative(limit, check["NR_over_2"], 1e-14, "N R / 2");
  expect_relative(hand.norm() / limit, check["ratio_total"], 1e-14, "m");
  EXPECT_GT(hand.norm(), limit);
}

TEST(Motion, RefusesInvalidValues)
{
  const auto refused = [](auto change)
  {
    Motion motion;
    change(motion);
    EXPECT_THROW(motion.validate(), std::invalid_argument);
    EXPECT_THROW(SelfConsistentRing(Closure::full, motion, 0.03), std::invalid_argument);
  };
  EXPECT_NO_THROW(Motion().validate());
  refused([](Motion &motion) { motion.mass = 0.; });
  refused([](Motion &motion) { motion.yaw_inertia = -1.; });
  refused([](Motion &motion) { motion.centre_of_mass_height = -0.1; });
  refused([](Motion &motion) { motion.force_offset = std::numeric_limits<double>::quiet_NaN(); });
  refused([](Motion &motion) { motion.orbit_radius = -0.15; });
  refused([](Motion &motion) { motion.orbit_speed = 0.; });
  refused([](Motion &motion) { motion.orbit_acceleration = std::numeric_limits<double>::infinity(); });
  refused([](Motion &motion) { motion.friction_coefficient = -0.3; });
  refused([](Motion &motion) { motion.gravity = 0.; });
  EXPECT_THROW(SelfConsistentRing(Closure::full, Motion(), 0.), std::invalid_argument);
}
} // namespace
} // namespace stemware::ring
