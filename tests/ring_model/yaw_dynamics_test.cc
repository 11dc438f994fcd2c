#include "ring_model/self_consistent_ring.h"
#include "ring_model/spin/hand_drive.h"
#include "ring_model/yaw_motion.h"
#include "tests/ring_model/reference.h"
#include "tests/taylor_remainder.h"

#include <Eigen/LU>

#include <stdexcept>

namespace stemware::ring
{
namespace
{
using test::expect_relative;
using test::reference;

/// yaw_motion() in units of 1 rad/s where there is no other scale.
std::vector<YawSample> spin_up(const PhasedTorqueFunction &torque, double inertia, double initial_spin,
                               const std::vector<double> &times, double accuracy = 1e-10,
                               double spin_scale = 1.)
{
  return yaw_motion(torque, inertia, initial_spin, times, accuracy, spin_scale);
}

/// Closure `paper` with the inertia that the reference chose.
class PaperSpinUp : public ::testing::Test
{
protected:
  const nlohmann::json &rows = reference()["time_evolution_A"];
  const double inertia = rows["Iz"];
  const SelfConsistentRing ring{ Closure::paper, Motion(), 0.03 };
  const TorqueFunction torque = [this](double omega) { return ring.torque(omega); };
  const PhasedTorqueFunction timed = [this](double, double, double omega) { return ring.torque(omega); };
};

TEST_F(PaperSpinUp, FollowsTheReferenceRows)
{
  expect_relative(torque(0.) / inertia, rows["omega_dot_0"], 1e-14, "initial acceleration");
  std::vector<double> times;
  for (const auto &row : rows["rows"])
    times.push_back(row["t"]);
  const auto samples = spin_up(timed, inertia, 0., times, 1e-12);
  for (std::size_t i = 0; i < times.size(); ++i)
  {
    expect_relative(samples[i].omega, rows["rows"][i]["omega"], 1e-11,
                    "omega at t = " + std::to_string(times[i]));
    expect_relative(torque(rows["rows"][i]["omega"]), rows["rows"][i]["tau"], 1e-12, "tau");
  }
  const auto decimal = spin_up(timed, inertia, 0., { 0.1, 0.2 }, 1e-12);
  expect_relative(decimal[0].omega, rows["omega_at_t0p1"], 1e-11, "omega(0.1 s)");
  expect_relative(decimal[1].omega, rows["omega_at_t0p2"], 1e-11, "omega(0.2 s)");
}

TEST_F(PaperSpinUp, HasTheAccuracyThatWasAskedFor)
{
  // Dense output at 200 times against the same run two decades sharper.
  std::vector<double> times;
  for (unsigned int i = 0; i <= 200; ++i)
    times.push_back(0.01 * i);
  for (const double accuracy : { 1e-6, 1e-8, 1e-10 })
  {
    const auto samples = spin_up(timed, inertia, 0., times, accuracy, 0.35 / 0.03);
    const auto sharper = spin_up(timed, inertia, 0., times, accuracy / 100., 0.35 / 0.03);
    for (std::size_t i = 0; i < times.size(); ++i)
      EXPECT_NEAR(samples[i].omega, sharper[i].omega, accuracy * 0.35 / 0.03) << times[i];
  }
  expect_relative(spin_up(timed, inertia, 0., { 20. }, 1e-10)[0].omega, test::terminal_spin_of(ring).omega,
                  1e-9, "terminal");
}

TEST_F(PaperSpinUp, EulerConvergesAtFirstOrderToTheAdaptiveSolution)
{
  const double exact = spin_up(timed, inertia, 0., { 0.1 }, 1e-12)[0].omega;
  double previous = 0.;
  for (const unsigned int n_steps : { 100u, 200u, 400u, 800u })
  {
    const auto samples = yaw_motion_euler(timed, inertia, 0., 0.1 / n_steps, n_steps);
    ASSERT_EQ(samples.size(), n_steps + 1);
    const double error = std::abs(samples.back().omega - exact);
    if (previous > 0.)
    {
      EXPECT_NEAR(std::log2(previous / error), 1., 0.01);
    }
    previous = error;
  }
}

TEST_F(PaperSpinUp, RefusesBadInput)
{
  EXPECT_THROW(spin_up(timed, -1., 0., { 1. }), std::invalid_argument);
  EXPECT_THROW(spin_up(timed, inertia, 0., { 1., 0.5 }), std::invalid_argument);
  EXPECT_THROW(spin_up(timed, inertia, 0., { -1. }), std::invalid_argument);
  EXPECT_THROW(spin_up(timed, inertia, 0., { 1. }, 0.), std::invalid_argument);
  EXPECT_TRUE(spin_up(timed, inertia, 0., {}).empty());
  EXPECT_EQ(spin_up(timed, inertia, 0.5, { 0. })[0].omega, 0.5);
}

TEST(OrbitSpeedTable, IsExactMonotoneAndDoesNotExtrapolate)
{
  const OrbitSpeedTable table({ 0., 0.5, 1., 1.5, 3. }, { 0.1, 0.3, 0.35, 0.35, 0.2 });
  EXPECT_EQ(table.speed(0.5), 0.3);
  EXPECT_DOUBLE_EQ(table.speed(3.), 0.2);
  for (double t = 0.; t < 1.; t += 0.01)
  {
    EXPECT_LE(table.speed(t), table.speed(t + 0.01));
    EXPECT_TRUE(taylor::is_derivative([&](double h) { return table.speed(t + 0.002 + h); },
                                      table.acceleration(t + 0.002), 0.005))
      << t;
  }
  EXPECT_NEAR(table.speed(1.2), 0.35, 1e-15); // no overshoot over the plateau
  EXPECT_THROW(table.speed(3.1), std::out_of_range);
  EXPECT_THROW(table.acceleration(-0.1), std::out_of_range);

  const OrbitSpeedTable ramp({ 0., 2. }, { 0.1, 0.5 });
  EXPECT_NEAR(ramp.speed(0.7), 0.24, 1e-15);
  EXPECT_NEAR(ramp.acceleration(0.7), 0.2, 1e-14);

  EXPECT_THROW(OrbitSpeedTable({ 0. }, { 1. }), std::invalid_argument);
  EXPECT_THROW(OrbitSpeedTable({ 0., 1. }, { 1., 0. }), std::invalid_argument);
  EXPECT_THROW(OrbitSpeedTable({ 0., 1. }, { 0., 0. }), std::invalid_argument);
  EXPECT_THROW(OrbitSpeedTable({ 0., 0. }, { 1., 1. }), std::invalid_argument);
}

TEST(OrbitSpeedTable, MayBeginAtRest)
{
  const OrbitSpeedTable table({ 0., 0.5, 1., 2. }, { 0., 0., 0.3, 0.4 });
  EXPECT_TRUE(table.starts_from_rest());
  EXPECT_EQ(table.speed(0.2), 0.);
  EXPECT_EQ(table.time_of(0.), 0.5);
  EXPECT_NEAR(table.speed(table.time_of(0.12)), 0.12, 1e-15);
  EXPECT_NEAR(table.time_of(0.4), 2., 1e-6);
  EXPECT_THROW(table.time_of(0.41), std::out_of_range);
  EXPECT_NO_THROW(table.motion_at(Motion(), 0.1).validate());
  EXPECT_FALSE(OrbitSpeedTable({ 0., 1. }, { 0.1, 0.2 }).starts_from_rest());
}

TEST(OrbitSpeedTable, CanBeJoinedByLines)
{
  const OrbitSpeedTable table({ 0., 0.5, 1., 1.5, 3. }, { 0.1, 0.3, 0.35, 0.35, 0.2 });
  const OrbitSpeedTable lines = table.joined_by_lines();
  for (const auto &[time, speed] :
       { std::pair(0., 0.1), { 0.25, 0.2 }, { 0.5, 0.3 }, { 2.25, 0.275 }, { 3., 0.2 } })
    EXPECT_NEAR(lines.speed(time), speed, 1e-14) << time;
  for (const auto &[time, acceleration] : { std::pair(0.1, 0.4), { 0.6, 0.1 }, { 1.2, 0. }, { 3., -0.1 } })
    EXPECT_NEAR(lines.acceleration(time), acceleration, 1e-13) << time;
  EXPECT_THROW(lines.speed(3.1), std::out_of_range);
  EXPECT_GT(std::abs(table.speed(0.25) - 0.2), 1e-3); // another reading
}

TEST(HandDrive, ConstantTableIsTheMotor)
{
  const Motion motion;
  const SelfConsistentRing ring(Closure::full, motion, 0.03);
  const auto driven = driven_torque(Closure::full, motion, 0.03, OrbitSpeedTable({ 0., 2. }, { 0.35, 0.35 }));
  const auto by_table = spin_up(driven, motion.yaw_inertia, 0., { 0.3, 2. });
  const auto by_motor = spin_up([&](double, double, double omega) { return ring.torque(omega); },
                                motion.yaw_inertia, 0., { 0.3, 2. });
  for (unsigned int i = 0; i < 2; ++i)
    expect_relative(by_table[i].omega, by_motor[i].omega, 1e-9, "omega");
}

TEST(HandDrive, FollowsARampLikeAClassicalRungeKutta)
{
  const Motion motion;
  const OrbitSpeedTable table({ 0., 0.4, 0.8, 1.2 }, { 0.1, 0.3, 0.4, 0.35 });
  for (const auto &torque : { driven_torque(Closure::hand, motion, 0.03, table),
                              driven_torque(Closure::full, motion, 0.03, table) })
  {
    // Fourth order with fixed steps, each table entry at the end of a step.
    double omega = 0.;
    const unsigned int n_steps = 1200;
    const double step = 1.2 / n_steps;
    const auto rate = [&](double t, double spin)
    { return torque(std::min(t, 1.2), 0., spin) / motion.yaw_inertia; };
    for (unsigned int i = 0; i < n_steps; ++i)
    {
      const double t = i * step, k1 = rate(t, omega), k2 = rate(t + step / 2., omega + step / 2. * k1),
                   k3 = rate(t + step / 2., omega + step / 2. * k2), k4 = rate(t + step, omega + step * k3);
      omega += step / 6. * (k1 + 2. * k2 + 2. * k3 + k4);
    }
    EXPECT_NEAR(spin_up(torque, motion.yaw_inertia, 0., { 0.6, 1.2 }, 1e-10)[1].omega, omega, 1e-8);
  }
}

TEST(HandDrive, TorqueOnARampIsThatOfAllMomentsWrittenOut)
{
  // While the hand speeds up, M_N = -dz m k x acceleration + (z_CM + dz) k x T = pi R (b_1, -a_1). Friction
  // by sums over the rim: columns are those of the loads 1, cos theta and sin theta, rows T_x, T_y and tau_z.
  constexpr double radius = 0.03, mass = 0.3, offset = -0.05, arm = 0.08 + offset;
  constexpr double speed = 0.35, acceleration = 2., omega = -3.;
  const double turn = 2. * std::acos(-1.), a_0 = mass * 9.81 / turn, lever = turn / 2. * radius;
  Eigen::Matrix3d friction = Eigen::Matrix3d::Zero();
  constexpr unsigned int n_points = 360;
  for (unsigned int i = 0; i < n_points; ++i)
  {
    const double c = std::cos(turn * i / n_points), s = std::sin(turn * i / n_points);
    const Eigen::Vector2d slip(speed - omega * radius * s, omega * radius * c);
    const Eigen::Vector2d force = -0.3 * turn / n_points * slip.normalized();
    friction += Eigen::Vector3d(force.x(), force.y(), radius * (c * force.y() - s * force.x())) *
                Eigen::RowVector3d(1., c, s);
  }
  const Eigen::Matrix2d balance = lever * Eigen::Matrix2d::Identity() + arm * friction.topRightCorner<2, 2>();
  const Eigen::Vector2d inertia = offset * mass * Eigen::Vector2d(acceleration, speed * speed / 0.15);
  const Eigen::Vector2d a_b = balance.inverse() * (inertia - arm * a_0 * friction.topLeftCorner<2, 1>());
  const double expected = friction.row(2).dot(Eigen::RowVector3d(a_0, a_b.x(), a_b.y()));

  const OrbitSpeedTable ramp({ 0., 0.2 }, { speed - 0.1 * acceleration, speed + 0.1 * acceleration });
  expect_relative(driven_torque(Closure::full, Motion(), radius, ramp)(0.1, 0., omega), expected, 1e-12,
                  "formula");
}

TEST(HandDrive, TangentialForceTiltsTheGlass)
{
  // Speeding up, the hand pushes forward with m dv/dt at Delta z: M_N,y = -Delta z m dv/dt more than at
  // constant speed.
  Motion motion;
  const Eigen::Vector2d steady = required_moment(Closure::hand, motion, { -0.8, 0. });
  motion.orbit_acceleration = 2.;
  const Eigen::Vector2d pushed = required_moment(Closure::hand, motion, { -0.8, 0. });
  EXPECT_NEAR(pushed.y() - steady.y(), 0.05 * 0.3 * 2., 1e-16);
  EXPECT_EQ(pushed.x(), steady.x());
  EXPECT_EQ(required_moment(Closure::paper, motion, { -0.8, 0. }).y(), 0.);
}
} // namespace
} // namespace stemware::ring
