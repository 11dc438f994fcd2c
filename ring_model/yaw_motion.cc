#include "ring_model/yaw_motion.h"

#include "ring_model/failures.h"
#include "ring_model/load/require.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace stemware::ring
{
namespace
{
/// Returns the mean spin of equidistant samples, weighted by a smooth window that vanishes at both ends.
double smooth_mean(const std::vector<YawSample> &samples)
{
  double sum = 0., weights = 0.;
  for (std::size_t i = 1; i + 1 < samples.size(); ++i)
  {
    const double s = static_cast<double>(i) / static_cast<double>(samples.size() - 1);
    const double weight = std::exp(-1. / (s * (1. - s)));
    sum += weight * samples[i].omega;
    weights += weight;
  }
  return sum / weights;
}

/// Returns the maximum of the parabola through the largest of the equidistant @p values and its neighbours.
double largest(const std::vector<double> &values)
{
  const auto place = std::max_element(values.begin(), values.end());
  if (place == values.begin() || place + 1 == values.end())
    return *place;
  const double slope = (place[1] - place[-1]) / 2., curvature = place[1] - 2. * place[0] + place[-1];
  return curvature < 0. ? *place - slope * slope / (2. * curvature) : *place;
}

double half_range(const std::vector<YawSample> &samples)
{
  std::vector<double> up, down;
  for (const YawSample &sample : samples)
  {
    up.push_back(sample.omega);
    down.push_back(-sample.omega);
  }
  return (largest(up) + largest(down)) / 2.;
}

void require_motion(double yaw_inertia, double initial_spin, double accuracy, double spin_scale)
{
  require_positive(yaw_inertia, "the yaw inertia", "kg m^2");
  require_positive(accuracy, "the requested accuracy", "");
  require_positive(spin_scale, "the spin scale v / R", "rad/s");
  require_finite(initial_spin, "the initial spin [rad/s]");
}
} // namespace

double grip_torque(double torque, double omega, double grip)
{
  if (omega == 0)
    return -std::copysign(std::min(std::abs(torque), grip), torque);
  return -std::copysign(grip, omega);
}

PhasedTorqueFunction observed(PhasedTorqueFunction torque, TimeObserver observer)
{
  if (!observer)
    return torque;
  return [torque = std::move(torque), observer = std::move(observer)](double time, double angle, double omega)
  {
    observer(time);
    return torque(time, angle, omega);
  };
}

std::vector<YawSample> yaw_motion(const PhasedTorqueFunction &torque, double yaw_inertia, double initial_spin,
                                  const std::vector<double> &times, double accuracy, double spin_scale,
                                  double grip, const std::vector<double> &breaks)
{
  require_motion(yaw_inertia, initial_spin, accuracy, spin_scale);
  require(std::isfinite(grip) && grip >= 0., "the grip torque is ", grip, " N m, but must be at least 0");
  require(std::is_sorted(breaks.begin(), breaks.end()), "the ", breaks.size(),
          " times at which the torque has a break must increase");
  require(std::is_sorted(times.begin(), times.end()) &&
            (times.empty() || (times.front() >= 0. && std::isfinite(times.back()))),
          "the ", times.size(), " output times must be finite, increasing and not negative");
  return gripped_motion({ 0., 0., initial_spin }, torque, yaw_inertia, times, accuracy, spin_scale, grip,
                        breaks);
}

std::vector<YawSample> yaw_motion_euler(const PhasedTorqueFunction &torque, double yaw_inertia,
                                        double initial_spin, double time_step, unsigned int n_steps,
                                        double grip)
{
  require_positive(yaw_inertia, "the yaw inertia", "kg m^2");
  require_positive(time_step, "the time step", "s");
  require_finite(initial_spin, "the initial spin [rad/s]");
  std::vector<YawSample> samples{ { 0., 0., initial_spin } };
  samples.reserve(n_steps + 1);
  for (unsigned int i = 1; i <= n_steps; ++i)
  {
    const auto [time, angle, omega] = samples.back();
    const double free = torque(time, angle, omega),
                 next = omega + (free + grip_torque(free, omega, grip)) / yaw_inertia * time_step;
    // The grip stops a spin but does not reverse it.
    const bool stops = omega * next < 0. && std::abs(free) <= grip;
    samples.push_back({ i * time_step, angle + omega * time_step, stops ? 0. : next });
  }
  return samples;
}

TerminalSpin long_time_spin(const PhasedTorqueFunction &torque, double yaw_inertia, double initial_spin,
                            double window, double accuracy, double spin_scale, double grip)
{
  constexpr unsigned int n_samples = 2048, n_windows = 8, n_doublings = 2;
  constexpr double largest_uncertainty = 1e-5;
  require_motion(yaw_inertia, initial_spin, accuracy, spin_scale);
  require_positive(window, "the window of time", "s");
  YawSample state = { 0., 0., initial_spin };
  TerminalSpin spin;
  for (unsigned int doubling = 0; doubling <= n_doublings; ++doubling, window *= 2.)
  {
    std::vector<double> times;
    for (unsigned int i = 0; i <= n_samples << doubling; ++i)
      times.push_back(window * i / (n_samples << doubling));
    std::optional<double> before;
    for (unsigned int i = 0; i < n_windows; ++i)
    {
      const std::vector<YawSample> samples =
        gripped_motion(state, torque, yaw_inertia, times, accuracy / 10., spin_scale, grip);
      state = samples.back();
      spin.omega = spin.evaluated_at = smooth_mean(samples);
      spin.ripple = half_range(samples);
      spin.uncertainty = std::abs(spin.omega - before.value_or(spin.omega));
      if (before && spin.uncertainty <= accuracy * spin_scale)
        return spin;
      before = spin.omega;
    }
  }
  if (spin.uncertainty <= largest_uncertainty * spin_scale)
    return spin;
  throw NoBalance(sentence("the mean spin does not settle: windows of ", window / 2., " s still differ by ",
                           spin.uncertainty, " rad/s around ", spin.omega, " rad/s"));
}
} // namespace stemware::ring
