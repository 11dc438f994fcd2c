#include "ring_model/yaw_motion.h"

#include "ring_model/load/require.h"
#include "ring_model/no_balance.h"

#include <boost/numeric/odeint/algebra/array_algebra.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace stemware::ring
{
namespace
{
/// psi and omega / spin_scale: one accuracy for both.
using YawState = std::array<double, 2>;

/// A spin that follows its torque so fast that stability would ask an explicit method for very many steps: it
/// is the spin at which the torque is I d omega / dt, by the inertia's first order.
class FollowingSpin
{
public:
  FollowingSpin(const PhasedTorqueFunction &torque, double yaw_inertia, double spin_scale, double time_step)
      : torque(torque)
      , yaw_inertia(yaw_inertia)
      , spin_step(1e-5 * spin_scale)
      , time_step(time_step)
  {
  }

  /// Whether the spin next to @p start, followed for @p time [s], is one.
  bool is_one(const YawSample &start, double time) const
  {
    constexpr double many_time_constants = 1e6;
    return -slope(start.time, start.yaw_angle, start.omega) / yaw_inertia * time > many_time_constants;
  }

  /// The spin at a time and yaw angle, found from @p near.
  double at(double time, double yaw_angle, double near) const
  {
    const double omega = balanced(time, yaw_angle, near, slope(time, yaw_angle, near));
    const double here = slope(time, yaw_angle, omega);
    const double next = balanced(time + time_step, yaw_angle + omega * time_step, omega, here),
                 last = balanced(time - time_step, yaw_angle - omega * time_step, omega, here);
    return omega + yaw_inertia * (next - last) / (2. * time_step) / here;
  }

private:
  double slope(double time, double yaw_angle, double omega) const
  {
    return (torque(time, yaw_angle, omega + spin_step) - torque(time, yaw_angle, omega - spin_step)) /
           (2. * spin_step);
  }

  /// Where the torque vanishes, by the secant method; @p torque_slope: an estimate for the first step.
  double balanced(double time, double yaw_angle, double omega, double torque_slope) const
  {
    constexpr unsigned int max_steps = 20;
    double here = torque(time, yaw_angle, omega);
    for (unsigned int i = 0; i < max_steps; ++i)
    {
      const double step = -here / torque_slope;
      omega += step;
      if (std::abs(step) < 1e-6 * spin_step)
        return omega;
      const double next = torque(time, yaw_angle, omega);
      torque_slope = (next - here) / step;
      here = next;
    }
    throw NoBalance(
      sentence("the quasi-steady spin was not found at t = ", time, " s near ", omega, " rad/s"));
  }

  const PhasedTorqueFunction &torque;
  const double yaw_inertia;
  const double spin_step; ///< of differences [rad/s]
  const double time_step; ///< over which the phase changes little [s]
};

/// The motion from @p start on, sampled at @p times counted from there: by the
/// Dormand-Prince pair with step control and dense output (Boost.Odeint). The torque is never asked for at
/// times beyond the last of @p times, but by a FollowingSpin, which @p may_follow allows.
std::vector<YawSample> motion_from(const YawSample &start, const PhasedTorqueFunction &torque,
                                   double yaw_inertia, const std::vector<double> &times, double accuracy,
                                   double spin_scale, bool may_follow = false)
{
  // The error of one step is held a decade below the request: errors of all steps add up, and the
  // interpolation between steps is one order lower than the steps themselves.
  namespace odeint = boost::numeric::odeint;
  auto stepper =
    odeint::make_dense_output(accuracy / 10., accuracy / 10., odeint::runge_kutta_dopri5<YawState>());
  const double end = times.empty() ? 0. : times.back();
  const FollowingSpin following(torque, yaw_inertia, spin_scale, 1e-5 * end);
  const bool follows = may_follow && following.is_one(start, end);
  const auto rate_of = [&](const YawState &state, YawState &rate, double time)
  {
    rate[0] = (follows ? following.at(start.time + time, state[0], start.omega) : state[1] * spin_scale);
    rate[1] =
      follows ? 0. : torque(start.time + std::min(time, end), state[0], rate[0]) / (yaw_inertia * spin_scale);
  };
  const double push = std::abs(torque(start.time, start.yaw_angle, start.omega)) / yaw_inertia;
  const YawState first = { start.yaw_angle, start.omega / spin_scale };
  stepper.initialize(first, 0., 1e-3 / std::max(push / spin_scale, 1.));

  std::vector<YawSample> samples;
  samples.reserve(times.size());
  for (const double time : times)
  {
    unsigned int n_steps = 0;
    while (stepper.current_time() < time * (1. - 1e-15))
    {
      // The last step ends at the last output: a torque given by a table may be unknown beyond.
      if (stepper.current_time() + stepper.current_time_step() > end)
        stepper.initialize(YawState(stepper.current_state()), stepper.current_time(),
                           end - stepper.current_time());
      stepper.do_step(rate_of);
      const auto &[angle, spin] = stepper.current_state();
      if (++n_steps > 100000 || !std::isfinite(angle) || !std::isfinite(spin))
        throw NoBalance(sentence("the spin-up did not reach t = ", time, " s: stuck at t = ",
                                 stepper.current_time(), " s; request a lower accuracy than ", accuracy));
    }
    YawState state = first;
    if (time > 0.)
      stepper.calc_state(time, state);
    const double omega =
      follows ? following.at(start.time + time, state[0], start.omega) : state[1] * spin_scale;
    samples.push_back({ start.time + time, state[0], omega });
  }
  return samples;
}

/// Mean of equidistant samples with a weight that comes and goes smoothly.
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

/// Largest of equidistant values, at the vertex of the parabola through it and its neighbours.
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

std::vector<YawSample> yaw_motion(const PhasedTorqueFunction &torque, double yaw_inertia, double initial_spin,
                                  const std::vector<double> &times, double accuracy, double spin_scale)
{
  require_motion(yaw_inertia, initial_spin, accuracy, spin_scale);
  require(std::is_sorted(times.begin(), times.end()) &&
            (times.empty() || (times.front() >= 0. && std::isfinite(times.back()))),
          "the ", times.size(), " output times must be finite, increasing and not negative");
  return motion_from({ 0., 0., initial_spin }, torque, yaw_inertia, times, accuracy, spin_scale);
}

std::vector<YawSample> yaw_motion_euler(const PhasedTorqueFunction &torque, double yaw_inertia,
                                        double initial_spin, double time_step, unsigned int n_steps)
{
  require_positive(yaw_inertia, "the yaw inertia", "kg m^2");
  require_positive(time_step, "the time step", "s");
  require_finite(initial_spin, "the initial spin [rad/s]");
  std::vector<YawSample> samples{ { 0., 0., initial_spin } };
  samples.reserve(n_steps + 1);
  for (unsigned int i = 1; i <= n_steps; ++i)
  {
    const auto [time, angle, omega] = samples.back();
    samples.push_back({ i * time_step, angle + omega * time_step,
                        omega + torque(time, angle, omega) / yaw_inertia * time_step });
  }
  return samples;
}

LongTimeSpin long_time_spin(const PhasedTorqueFunction &torque, double yaw_inertia, double initial_spin,
                            double window, double accuracy, double spin_scale)
{
  constexpr unsigned int n_samples = 2048, n_windows = 8, n_doublings = 2;
  constexpr double largest_uncertainty = 1e-5;
  require_motion(yaw_inertia, initial_spin, accuracy, spin_scale);
  require_positive(window, "the window of time", "s");
  YawSample state = { 0., 0., initial_spin };
  LongTimeSpin spin = {};
  for (unsigned int doubling = 0; doubling <= n_doublings; ++doubling, window *= 2.)
  {
    std::vector<double> times;
    for (unsigned int i = 0; i <= n_samples << doubling; ++i)
      times.push_back(window * i / (n_samples << doubling));
    std::optional<double> before;
    for (unsigned int i = 0; i < n_windows; ++i)
    {
      const std::vector<YawSample> samples =
        motion_from(state, torque, yaw_inertia, times, accuracy / 10., spin_scale, true);
      state = samples.back();
      spin.mean = smooth_mean(samples);
      spin.ripple = half_range(samples);
      spin.uncertainty = std::abs(spin.mean - before.value_or(spin.mean));
      if (before && spin.uncertainty <= accuracy * spin_scale)
        return spin;
      before = spin.mean;
    }
  }
  if (spin.uncertainty <= largest_uncertainty * spin_scale)
    return spin;
  throw NoBalance(sentence("the mean spin does not settle: windows of ", window / 2., " s still differ by ",
                           spin.uncertainty, " rad/s around ", spin.mean, " rad/s"));
}
} // namespace stemware::ring
