#include "ring_model/load/constants.h"
#include "ring_model/self_consistent_ring.h"
#include "ring_model/spin/hand_drive.h"
#include "ring_model/yaw_motion.h"
#include "tests/ring_model/reference.h"
#include "tests/taylor_remainder.h"
#include "tests/ulps.h"

#include <Eigen/LU>

#include <stdexcept>

namespace stemware::ring
{
namespace
{

TEST(PaperSpinUp, AgreesWithTheReference)
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

TEST(OrbitSpeedTable, InterpolatesMonotonicallyAndRefusesInvalidTimesAndSpeeds)
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
  EXPECT_NEAR(table.speed(1.2), 0.35, ulps(13, 0.35)); // the cubic does not overshoot the plateau
  EXPECT_THROW(table.speed(3.1), std::out_of_range);
  EXPECT_THROW(table.acceleration(-0.1), std::out_of_range);

  const OrbitSpeedTable ramp({ 0., 2. }, { 0.1, 0.5 });
  EXPECT_NEAR(ramp.speed(0.7), 0.24, ulps(13, 0.35));
  EXPECT_NEAR(ramp.acceleration(0.7), 0.2, 1e-14);

  EXPECT_THROW(OrbitSpeedTable({ 0. }, { 1. }), std::invalid_argument);
  EXPECT_THROW(OrbitSpeedTable({ 0., 1. }, { 1., 0. }), std::invalid_argument);
  EXPECT_THROW(OrbitSpeedTable({ 0., 1. }, { 0., 0. }), std::invalid_argument);
  EXPECT_THROW(OrbitSpeedTable({ 0., 0. }, { 1., 1. }), std::invalid_argument);
}

TEST(OrbitSpeedTable, AllowsZeroSpeedAtTheStartAndFindsTimesOfSpeeds)
{
  const OrbitSpeedTable table({ 0., 0.5, 1., 2. }, { 0., 0., 0.3, 0.4 });
  EXPECT_TRUE(table.starts_from_rest());
  EXPECT_EQ(table.speed(0.2), 0.);
  EXPECT_EQ(table.time_of(0.), 0.5);
  EXPECT_NEAR(table.speed(table.time_of(0.12)), 0.12, ulps(13, 0.35));
  EXPECT_NEAR(table.time_of(0.4), 2., 1e-6);
  EXPECT_THROW(table.time_of(0.41), std::out_of_range);
  EXPECT_NO_THROW(table.motion_at(Motion(), 0.1).validate());
  EXPECT_FALSE(OrbitSpeedTable({ 0., 1. }, { 0.1, 0.2 }).starts_from_rest());
}

TEST(OrbitSpeedTable, InterpolatesLinearlyOnRequest)
{
  const OrbitSpeedTable table({ 0., 0.5, 1., 1.5, 3. }, { 0.1, 0.3, 0.35, 0.35, 0.2 });
  const OrbitSpeedTable lines = table.joined_by_lines();
  for (const auto &[time, speed] :
       { std::pair(0., 0.1), { 0.25, 0.2 }, { 0.5, 0.3 }, { 2.25, 0.275 }, { 3., 0.2 } })
    EXPECT_NEAR(lines.speed(time), speed, 1e-14) << time;
  for (const auto &[time, acceleration] : { std::pair(0.1, 0.4), { 0.6, 0.1 }, { 1.2, 0. }, { 3., -0.1 } })
    EXPECT_NEAR(lines.acceleration(time), acceleration, 1e-13) << time;
  EXPECT_THROW(lines.speed(3.1), std::out_of_range);
  EXPECT_GT(std::abs(table.speed(0.25) - 0.2), 1e-3); // the monotone cubic differs from the polygon
}

/// Independent reference for a driven glass. Speeds: monotone cubic of Fritsch and Carlson. Friction force T
/// and torque: sums over the rim. Moment of the load: M_N = -dz m e_z x acceleration + (z_CM + dz) e_z x T.
/// Time integration: classical Runge-Kutta, with steps that end at the times of the table and at zero spin.
struct DrivenReference
{
  std::vector<double> times, speeds;
  double grip = 0.;

  std::vector<double> slopes() const
  {
    const std::size_t n = times.size();
    std::vector<double> secants, slopes(n, 0.);
    for (std::size_t i = 0; i + 1 < n; ++i)
      secants.push_back((speeds[i + 1] - speeds[i]) / (times[i + 1] - times[i]));
    slopes.front() = secants.front();
    slopes.back() = secants.back();
    for (std::size_t i = 1; i + 1 < n; ++i)
      if (secants[i - 1] * secants[i] > 0.)
      {
        const double before = times[i] - times[i - 1], after = times[i + 1] - times[i];
        slopes[i] = 3. * (before + after) /
                    ((2. * after + before) / secants[i - 1] + (after + 2. * before) / secants[i]);
      }
    return slopes;
  }

  /// Returns the torque without the grip [N m], @p since [s] after the start of interval @p i.
  double torque(std::size_t i, double since, double omega) const
  {
    static const double turn = 2. * pi;
    constexpr double radius = 0.03, mass = 0.3, offset = -0.05, arm = 0.08 + offset;
    const std::vector<double> at_rows = slopes();
    const double h = times[i + 1] - times[i], s = since / h, a = speeds[i], b = speeds[i + 1],
                 c = h * at_rows[i], d = h * at_rows[i + 1];
    const double v = a + s * (c + s * (3. * (b - a) - 2. * c - d + s * (2. * (a - b) + c + d)));
    const double acceleration =
      (c + s * (2. * (3. * (b - a) - 2. * c - d) + s * 3. * (2. * (a - b) + c + d))) / h;
    // Columns: friction under the loads 1, cos theta and sin theta. Rows: T_x, T_y and tau_z.
    Eigen::Matrix3d friction = Eigen::Matrix3d::Zero();
    constexpr unsigned int n_points = 600;
    for (unsigned int k = 0; k < n_points; ++k)
    {
      const double angle = turn * (k + 0.5) / n_points, x = std::cos(angle), y = std::sin(angle);
      const Eigen::Vector2d slip(v - omega * radius * y, omega * radius * x);
      const Eigen::Vector2d force = -0.3 * turn / n_points * slip.normalized();
      friction += Eigen::Vector3d(force.x(), force.y(), radius * (x * force.y() - y * force.x())) *
                  Eigen::RowVector3d(1., x, y);
    }
    const double a_0 = mass * 9.81 / turn, lever = turn / 2. * radius;
    const Eigen::Matrix2d balance =
      lever * Eigen::Matrix2d::Identity() + arm * friction.topRightCorner<2, 2>();
    const Eigen::Vector2d inertia = offset * mass * Eigen::Vector2d(acceleration, v * v / 0.15);
    const Eigen::Vector2d a_b = balance.inverse() * (inertia - arm * a_0 * friction.topLeftCorner<2, 1>());
    return friction.row(2).dot(Eigen::RowVector3d(a_0, a_b.x(), a_b.y()));
  }

  /// Returns times [s] and spins [rad/s], with @p n_steps steps between two times of the table. Sets @p held
  /// to the last time at which the glass stops.
  std::vector<std::pair<double, double>> motion(unsigned int n_steps, double *held = nullptr) const
  {
    constexpr double inertia = 3e-4;
    std::vector<std::pair<double, double>> found{ { times[0], 0. } };
    double omega = 0.;
    for (std::size_t i = 0; i + 1 < times.size(); ++i)
      for (unsigned int k = 0; k < n_steps; ++k)
      {
        const double length = (times[i + 1] - times[i]) / n_steps, end = (k + 1) * length;
        double begin = k * length;
        const auto is_held = [&](double since) { return std::abs(torque(i, since, 0.)) <= grip; };
        if (omega == 0. && is_held(begin))
        {
          double free = end;
          if (!is_held(end))
            while (free - begin > 1e-12)
              (is_held((begin + free) / 2.) ? begin : free) = (begin + free) / 2.;
          begin = free;
        }
        const double whole = end - begin;
        if (whole == 0.)
        {
          found.emplace_back(times[i] + end, 0.);
          continue;
        }
        const double turns = omega != 0. ? std::copysign(1., omega) : std::copysign(1., torque(i, begin, 0.));
        const auto rate = [&](double since, double w)
        { return (torque(i, since, w) - turns * grip) / inertia; };
        const auto after = [&](double step)
        {
          const double r1 = rate(begin, omega), r2 = rate(begin + step / 2., omega + step / 2. * r1),
                       r3 = rate(begin + step / 2., omega + step / 2. * r2),
                       r4 = rate(begin + step, omega + step * r3);
          return omega + step / 6. * (r1 + 2. * r2 + 2. * r3 + r4);
        };
        double next = after(whole);
        if (turns * next < 0. && grip > 0.)
        {
          double turning = 0., stopped = whole;
          while (stopped - turning > 1e-12)
            (turns * after((turning + stopped) / 2.) > 0. ? turning : stopped) = (turning + stopped) / 2.;
          if (held)
            *held = times[i] + begin + stopped;
          next = 0.;
        }
        omega = next;
        found.emplace_back(times[i] + begin + whole, omega);
      }
    return found;
  }

  double largest_error(double accuracy, unsigned int n_steps) const
  {
    const auto expected = motion(n_steps);
    std::vector<double> at;
    for (const auto &[time, omega] : expected)
      at.push_back(std::min(time, times.back()));
    const OrbitSpeedTable table(times, speeds);
    const auto found = driven_motion(driven_torque(Closure::full, Motion(), 0.03, table), table, Motion(),
                                     grip, 0.03, at, accuracy);
    double largest = 0.;
    for (std::size_t i = 0; i < at.size(); ++i)
      largest = std::max(largest, std::abs(found[i].omega - expected[i].second));
    return largest;
  }
};

TEST(HandDrive, TorqueOnARampAgreesWithTheMomentBalance)
{
  const DrivenReference ramp{ { 0., 0.2 }, { 0.15, 0.55 } };
  const OrbitSpeedTable table(ramp.times, ramp.speeds);
  expect_relative(driven_torque(Closure::full, Motion(), 0.03, table)(0.1, 0., -3.), ramp.torque(0, 0.1, -3.),
                  1e-12, "formula");
}

TEST(HandDrive, SpinAgreesWithRungeKuttaAtAndBetweenTheTimesOfTheTable)
{
  const DrivenReference braking{ { 0., 0.3, 0.55, 0.8, 1.1, 1.3 }, { 0.3, 0.35, 0.33, 0.15, 0.13, 0.2 } };
  EXPECT_LE(braking.largest_error(1e-6, 60), 1e-6 * 0.35 / 0.03);
}

TEST(HandDrive, FingersHoldAndReleaseTheGlass)
{
  const DrivenReference hand{ { 0., 0.4, 0.8, 1., 1.5, 2. }, { 0.35, 0.35, 0.05, 0.05, 0.3, 0.35 }, 0.0009 };
  double held = 0.;
  const auto expected = hand.motion(100, &held);
  EXPECT_GT(held, 0.8);
  EXPECT_LT(held, 1.);
  const OrbitSpeedTable table(hand.times, hand.speeds);
  const auto torque = driven_torque(Closure::full, Motion(), 0.03, table);
  const auto found =
    driven_motion(torque, table, Motion(), hand.grip, 0.03, { held - 1e-6, held + 1e-6, 1.1 }, 1e-9);
  EXPECT_LT(found[0].omega, 0.);
  EXPECT_EQ(found[1].omega, 0.);
  EXPECT_EQ(found[2].omega, 0.);
  EXPECT_LT(expected.back().second, -1.);
  EXPECT_LE(hand.largest_error(1e-9, 100), 1e-5);
}

} // namespace
} // namespace stemware::ring
