#include "ring_model/yaw_motion.h"

#include "ring_model/failures.h"
#include "ring_model/load/require.h"
#include "ring_model/stiff_motion.h"

#include <boost/math/tools/toms748_solve.hpp>
#include <boost/numeric/odeint/algebra/array_algebra.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

namespace stemware::ring
{
namespace
{
/// State (yaw angle [rad], omega / spin_scale). The scaling allows one tolerance for both components.
using YawState = std::array<double, 2>;

/// Motion of a glass braked by the fingers. Their friction jumps at omega = 0, so the integration stops
/// there. The glass then rests until the torque without the grip exceeds the grip torque, or turns back at
/// once.
class GrippedMotion
{
public:
  GrippedMotion(const PhasedTorqueFunction &torque, double yaw_inertia, double accuracy, double spin_scale,
                double grip, const std::vector<double> &breaks)
      : torque(torque)
      , yaw_inertia(yaw_inertia)
      , accuracy(accuracy)
      , spin_scale(spin_scale)
      , grip(grip)
      , breaks(breaks)
  {
  }

  /// Returns the motion at @p times after @p start. The torque is not evaluated after the last time.
  std::vector<YawSample> from(const YawSample &start, const std::vector<double> &times)
  {
    origin = start.time;
    wanted = &times;
    end = times.empty() ? 0. : times.back();
    now = { 0., start.yaw_angle, start.omega };
    samples.clear();
    samples.reserve(times.size());
    const double push = std::abs(free_torque(now)) / yaw_inertia;
    step = 1e-3 / std::max(push / spin_scale, 1.);
    is_stiff = stiff_motion(direction()).is_stiff(now, end, times.size());
    constexpr unsigned int max_stretches = 100000;
    for (unsigned int n = 0; samples.size() < times.size(); ++n)
    {
      if (n > max_stretches)
        throw NoBalance(
          sentence("the spin changes its sign at t = ", origin + now.time, " s again and again"));
      if (const int turns = direction(); turns == 0)
        rest();
      else if (is_stiff)
        turn_stiffly(turns);
      else
        turn(turns);
    }
    return std::move(samples);
  }

private:
  double free_torque(const YawSample &at) const
  {
    return torque(origin + std::min(at.time, end), at.yaw_angle, at.omega);
  }

  /// Returns the sense of the present or beginning rotation, 1 or -1; 0 while the fingers hold the glass.
  int direction() const
  {
    const double pushed = now.omega != 0. || grip == 0. ? now.omega : free_torque(now);
    if (now.omega == 0. && std::abs(pushed) <= grip && grip > 0.)
      return 0;
    return pushed < 0. ? -1 : 1;
  }

  StiffMotion stiff_motion(int turns) const
  {
    return { [=](double time, double angle, double omega) {
              return free_torque({ time, angle, omega }) - turns * grip;
            },
             yaw_inertia, accuracy, spin_scale };
  }

  /// Returns a positive value until the spin in the direction @p turns has ended. The margin suppresses
  /// reversals that are smaller than the integration error.
  double before_stop(int turns, double omega) const { return turns * omega / spin_scale + accuracy / 100.; }

  double next_break(double time) const
  {
    const double after = origin + time + 1e-13 * (std::abs(origin) + end);
    const auto next = std::upper_bound(breaks.begin(), breaks.end(), after);
    return next == breaks.end() ? end : std::min(*next - origin, end);
  }

  void stop(const YawSample &at) { now = { at.time, at.yaw_angle, 0. }; }

  void add(const YawSample &sample)
  {
    samples.push_back({ origin + (*wanted)[samples.size()], sample.yaw_angle, sample.omega });
  }

  bool is_due(double time) const
  {
    return samples.size() < wanted->size() && (*wanted)[samples.size()] * (1. - 1e-15) <= time;
  }

  /// Returns the root of @p positive, which changes sign between @p from and @p to, rounded towards @p to.
  template <typename Function>
  static double end_of(const Function &positive, double from, double to)
  {
    std::uintmax_t n_iterations = 100;
    return boost::math::tools::toms748_solve(positive, from, to,
                                             boost::math::tools::eps_tolerance<double>(48), n_iterations)
      .second;
  }

  void rest()
  {
    constexpr unsigned int n_looks = 64; // equally spaced checks of the torque until `end`
    const double look = (end - now.time) / n_looks;
    const auto excess = [&](double time) {
      return std::abs(free_torque({ time, now.yaw_angle, 0. })) - grip;
    };
    for (;;)
    {
      while (is_due(now.time))
        add(now);
      if (samples.size() == wanted->size())
        return;
      const double next = std::min({ (*wanted)[samples.size()], next_break(now.time), now.time + look });
      if (excess(next) > 0.)
      {
        // The excess may be exactly 0 at now.time, so the bracket begins slightly later.
        const double first = now.time + 1e-9 * (next - now.time);
        now.time = excess(first) < 0. ? end_of(excess, first, next) : first;
        while (is_due(now.time))
          add(now);
        step = 1e-3;
        return;
      }
      now.time = next;
    }
  }

  void turn(int turns)
  {
    namespace odeint = boost::numeric::odeint;
    constexpr unsigned int n_looks = 8; // checks of the spin per step, because it may reach 0 within a step
    const auto rate_of = [&](const YawState &state, YawState &rate, double time)
    {
      rate[0] = state[1] * spin_scale;
      rate[1] = (free_torque({ time, state[0], rate[0] }) - turns * grip) / (yaw_inertia * spin_scale);
    };
    auto stepper = odeint::make_dense_output(accuracy, accuracy, odeint::runge_kutta_dopri5<YawState>());
    stepper.initialize(YawState{ now.yaw_angle, now.omega / spin_scale }, now.time, step);
    const auto state_at = [&](double time) -> YawSample
    {
      YawState state;
      stepper.calc_state(time, state);
      return { time, state[0], state[1] * spin_scale };
    };
    const auto before = [&](double time) { return before_stop(turns, state_at(time).omega); };
    while (is_due(now.time))
      add(now);
    for (unsigned int n_steps = 0; samples.size() < wanted->size();)
    {
      const double from = stepper.current_time(), last = next_break(from);
      if (from + stepper.current_time_step() > last)
        stepper.initialize(YawState(stepper.current_state()), from, last - from);
      stepper.do_step(rate_of);
      const auto &[angle, spin] = stepper.current_state();
      const unsigned int n_done = static_cast<unsigned int>(samples.size());
      double to = stepper.current_time(), seen = from;
      bool stops = false;
      if (grip > 0.)
        for (unsigned int i = 1; i <= n_looks && !stops; ++i)
        {
          const double looked = i == n_looks ? to : from + (to - from) * i / n_looks;
          stops = before(looked) <= 0.;
          if (stops)
            to = before(seen) > 0. ? end_of(before, seen, looked) : seen;
          seen = looked;
        }
      while (is_due(to))
        add(state_at((*wanted)[samples.size()]));
      if (stops)
      {
        step = 1e-3;
        return stop(state_at(to));
      }
      n_steps = samples.size() > n_done ? 0 : n_steps + 1;
      if (n_steps > 100000 || !std::isfinite(angle) || !std::isfinite(spin))
        throw NoBalance(sentence("the spin-up did not reach t = ", origin + (*wanted)[samples.size()],
                                 " s: stuck at t = ", origin + stepper.current_time(),
                                 " s; request a lower accuracy than ", accuracy));
    }
  }

  void turn_stiffly(int turns)
  {
    const StiffMotion motion = stiff_motion(turns);
    while (is_due(now.time))
      add(now);
    for (unsigned int n_steps = 0; samples.size() < wanted->size(); ++n_steps)
    {
      const double last = std::min((*wanted)[samples.size()], next_break(now.time));
      const YawSample next = motion.after_step(now, last, step);
      if (grip > 0. && before_stop(turns, next.omega) <= 0. && before_stop(turns, now.omega) > 0.)
      {
        const auto before = [&](double time) {
          return before_stop(turns,
                             time > now.time ? motion.within_step(now, time - now.time).omega : now.omega);
        };
        const double stopped = end_of(before, now.time, next.time);
        return stop(stopped > now.time ? motion.within_step(now, stopped - now.time) : now);
      }
      now = next;
      while (is_due(now.time))
      {
        add(now);
        n_steps = 0;
      }
      if (n_steps > 100000)
        throw NoBalance(sentence("the spin was not found beyond t = ", origin + now.time, " s"));
    }
  }

  const PhasedTorqueFunction &torque;
  const double yaw_inertia, accuracy, spin_scale, grip;
  const std::vector<double> &breaks;
  const std::vector<double> *wanted = nullptr;
  std::vector<YawSample> samples;
  YawSample now = {}; ///< time relative to `origin`
  double origin = 0., end = 0., step = 0.;
  bool is_stiff = false;
};

/// Returns the motion at @p times after @p start. The tolerance of a step is a tenth of @p accuracy, because
/// step errors accumulate and the dense output is one order less accurate than the steps.
std::vector<YawSample> motion_from(const YawSample &start, const PhasedTorqueFunction &torque,
                                   double yaw_inertia, const std::vector<double> &times, double accuracy,
                                   double spin_scale, double grip, const std::vector<double> &breaks = {})
{
  return GrippedMotion(torque, yaw_inertia, accuracy / 10., spin_scale, grip, breaks).from(start, times);
}

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

double torque_with_grip(double torque, double omega, double grip)
{
  return torque + grip_torque(torque, omega, grip);
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
  return motion_from({ 0., 0., initial_spin }, torque, yaw_inertia, times, accuracy, spin_scale, grip,
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
                 next = omega + torque_with_grip(free, omega, grip) / yaw_inertia * time_step;
    // The grip stops a spin but does not reverse it.
    const bool stops = omega * next < 0. && std::abs(free) <= grip;
    samples.push_back({ i * time_step, angle + omega * time_step, stops ? 0. : next });
  }
  return samples;
}

LongTimeSpin long_time_spin(const PhasedTorqueFunction &torque, double yaw_inertia, double initial_spin,
                            double window, double accuracy, double spin_scale, double grip)
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
        motion_from(state, torque, yaw_inertia, times, accuracy / 10., spin_scale, grip);
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
