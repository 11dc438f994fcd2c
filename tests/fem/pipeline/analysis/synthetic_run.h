#pragma once

#include "fem/pipeline/study/measured_run.h"

#include <cmath>
#include <random>
#include <vector>

/// Runs of a glass that nobody has measured, by an integrator that shares no code with the program: friction
/// on a first harmonic by the midpoint rule round the ring, moment and friction in balance by iteration,
/// fourth-order Runge-Kutta steps.
namespace stemware::test
{

/// Seeds of the three thirds of the runs; they were fixed before the first fit.
inline constexpr unsigned int seeds_of_runs[] = { 20261126, 46, 904 };

/// A glass on a hand, closure full, counter-clockwise; SI units.
struct Truth
{
  double friction = 0.3, grip = 2e-4;
  double mass = 0.3, yaw_inertia = 3e-4, height = 0.08, force_offset = -0.05, orbit_radius = 0.15,
         speed = 0.35, radius = 0.03, gravity = 9.81;
};

/// Moments of the forces on the glass at a spin.
class TrueTorque
{
public:
  explicit TrueTorque(const Truth &truth)
      : truth(truth)
  {
  }

  double operator()(double omega) const
  {
    constexpr int n_points = 180, n_iterations = 60;
    const double normal = truth.mass * truth.gravity,
                 pull = truth.mass * truth.speed * truth.speed / truth.orbit_radius;
    double torque = 0, force_x = -truth.friction * normal, force_y = 0;
    for (int k = 0; k < n_iterations; ++k)
    {
      // M = -Delta z k x (m a - T) + z k x T with k x (u, w) = (-w, u).
      const double moment_x = truth.force_offset * (pull - force_y) - truth.height * force_y,
                   moment_y = truth.force_offset * force_x + truth.height * force_x;
      const double a = -moment_y / M_PI / truth.radius, b = moment_x / M_PI / truth.radius,
                   mean = normal / 2 / M_PI;
      double new_x = 0, new_y = 0, new_torque = 0;
      for (int i = 0; i < n_points; ++i)
      {
        const double angle = 2 * M_PI * (i + 0.5) / n_points, x = std::cos(angle), y = std::sin(angle);
        const double load = (mean + a * x + b * y) * 2 * M_PI / n_points;
        const double u = truth.speed - omega * truth.radius * y, w = omega * truth.radius * x;
        const double size = truth.friction * load / std::hypot(u, w);
        new_x -= size * u;
        new_y -= size * w;
        new_torque -= size * truth.radius * (x * w - y * u);
      }
      const bool is_done = std::abs(new_x - force_x) + std::abs(new_y - force_y) < 1e-13 * normal;
      force_x = new_x;
      force_y = new_y;
      torque = new_torque;
      if (is_done)
        break;
    }
    return torque;
  }

private:
  Truth truth;
};

/// Spin and yaw angle over the time in steps of `step`.
struct TrueMotion
{
  explicit TrueMotion(const Truth &truth, double step = 1e-3, double end = 3)
      : step(step)
  {
    const TrueTorque friction(truth);
    const auto acceleration = [&](double spin)
    {
      const double torque = friction(spin);
      if (spin == 0)
        return std::abs(torque) <= truth.grip
                 ? 0
                 : (torque - std::copysign(truth.grip, torque)) / truth.yaw_inertia;
      return (torque - std::copysign(truth.grip, spin)) / truth.yaw_inertia;
    };
    double spin = 0, turned = 0;
    for (double time = 0; time <= end; time += step)
    {
      omega.push_back(spin);
      angle.push_back(turned);
      const double k1 = acceleration(spin), k2 = acceleration(spin + step / 2 * k1),
                   k3 = acceleration(spin + step / 2 * k2), k4 = acceleration(spin + step * k3);
      turned += step * spin + step * step / 6 * (k1 + k2 + k3);
      spin += step / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    }
  }

  double spin(double time) const { return time <= 0 ? 0 : at(omega, time, omega.back()); }
  double yaw_angle(double time) const
  {
    const double end = step * static_cast<double>(omega.size() - 1);
    return time <= 0 ? 0 : at(angle, time, angle.back() + (time - end) * omega.back());
  }

  double step;
  std::vector<double> omega, angle;

private:
  double at(const std::vector<double> &values, double time, double beyond) const
  {
    const double place = time / step;
    const auto i = static_cast<std::size_t>(place);
    if (i + 2 >= values.size())
      return beyond;
    // The cubic through four values.
    const std::size_t first = i == 0 ? 0 : i + 2 < values.size() - 1 ? i - 1 : values.size() - 4;
    const double s = place - static_cast<double>(first);
    const double *y = &values[first];
    return y[0] * (s - 1) * (s - 2) * (s - 3) / -6 + y[1] * s * (s - 2) * (s - 3) / 2 +
           y[2] * s * (s - 1) * (s - 3) / -2 + y[3] * s * (s - 1) * (s - 2) / 6;
  }
};

/// Ways in which a run is measured.
enum class Sensor
{
  gyroscope, ///< from before the start
  late,      ///< a gyroscope that misses the start
  film,      ///< yaw angle in each frame
  film_turns ///< times at which a mark passes, every 45 degrees, in whole frames
};

/// Draws a run: 50 to 400 points a second with jitter, noise, offsets of time and of the gyroscope.
inline pipeline::MeasuredRun measured(const TrueMotion &motion, Sensor sensor, std::mt19937 &random)
{
  const auto uniform = [&](double from, double to)
  { return std::uniform_real_distribution<double>(from, to)(random); };
  const auto normal = [&](double spread) { return std::normal_distribution<double>(0, spread)(random); };
  pipeline::MeasuredRun run;
  run.is_angle = sensor == Sensor::film || sensor == Sensor::film_turns;
  const double rate = std::exp(uniform(std::log(50.), std::log(400.))), length = uniform(0.8, 1.6);
  const double start = uniform(0.05, 0.3), clock = uniform(-1, 1), zero = normal(0.01),
               noise = uniform(0.02, 0.1);
  const double begin = sensor == Sensor::late ? start + uniform(0.01, 0.06) : 0;
  if (sensor == Sensor::film_turns)
  {
    const double first_angle = uniform(0, 0.7);
    for (double time = start; time < start + 2.5; time += 1e-4)
    {
      const double before = std::abs(motion.yaw_angle(time - start - 1e-4)) + first_angle,
                   now = std::abs(motion.yaw_angle(time - start)) + first_angle;
      if (const double eighth = std::floor(now / (M_PI / 4)); eighth > std::floor(before / (M_PI / 4)))
      {
        run.times.push_back(std::round(time * rate) / rate + clock);
        run.values.push_back(std::copysign(eighth * M_PI / 4, motion.omega.back()));
      }
    }
    return run;
  }
  for (double time = begin; time < begin + length; time += 1 / rate)
  {
    const double jittered = time + uniform(-0.3, 0.3) / rate;
    if (!run.times.empty() && jittered + clock <= run.times.back())
      continue;
    run.times.push_back(jittered + clock);
    run.values.push_back(run.is_angle ? motion.yaw_angle(jittered - start) + normal(0.2 * noise)
                                      : motion.spin(jittered - start) + zero + normal(noise));
  }
  return run;
}

} // namespace stemware::test
