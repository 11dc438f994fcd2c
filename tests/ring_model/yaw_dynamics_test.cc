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

/// Closure `paper` with the inertia that the reference chose.
TEST(PaperSpinUp, FollowsTheReferenceRows)
{
  const nlohmann::json &rows = reference()["time_evolution_A"];
  const double inertia = rows["Iz"];
  const SelfConsistentRing ring(Closure::paper, Motion(), 0.03);
  expect_relative(ring.torque(0.) / inertia, rows["omega_dot_0"], 1e-14, "initial acceleration");
  const auto expect_spin = [&](double time, double omega)
  {
    const auto torque = [&](double, double, double spin) { return ring.torque(spin); };
    expect_relative(yaw_motion(torque, inertia, 0., { time }, 1e-12, 1.)[0].omega, omega, 1e-11,
                    "omega at t = " + std::to_string(time));
  };
  for (const auto &row : rows["rows"])
  {
    expect_spin(row["t"], row["omega"]);
    expect_relative(ring.torque(row["omega"]), row["tau"], 1e-12, "tau");
  }
  expect_spin(0.1, rows["omega_at_t0p1"]);
  expect_spin(0.2, rows["omega_at_t0p2"]);
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

} // namespace
} // namespace stemware::ring
