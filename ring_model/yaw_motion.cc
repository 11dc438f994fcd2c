#include "ring_model/yaw_motion.h"

#include "ring_model/load/require.h"
#include "ring_model/no_balance.h"

#include <Eigen/Dense>
#include <boost/numeric/odeint/algebra/array_algebra.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace stemware::ring
{
namespace
{
/// psi and omega / spin_scale: one accuracy for both.
using YawState = std::array<double, 2>;

/// Motion of a spin that follows its torque so fast that stability would limit an explicit method to steps of
/// its time constant. Three-stage Radau IIA collocation: order 5, and without inertia each stage is the zero
/// of the torque (Hairer & Wanner, Solving Ordinary Differential Equations II, IV.5).
class StiffMotion
{
public:
  StiffMotion(const PhasedTorqueFunction &torque, double yaw_inertia, double accuracy, double spin_scale)
      : torque(torque)
      , yaw_inertia(yaw_inertia)
      , accuracy(accuracy)
      , spin_scale(spin_scale)
  {
  }

  /// Whether few steps between the @p n_times outputs until the time @p end [s] after @p start are cheaper
  /// than explicit steps.
  bool is_stiff(const YawSample &start, double end, std::size_t n_times) const
  {
    // Some 30 torques a step, while explicit steps take two a time constant.
    constexpr double min_time_constants = 20.;
    // The torque of a grip jumps at rest: its slope is that beside the jump, where the glass turns to.
    YawSample beside = start;
    beside.omega += std::copysign(2e-5 * spin_scale, torque(start.time, start.yaw_angle, start.omega));
    return -slopes(beside).spin / yaw_inertia * end > min_time_constants * static_cast<double>(n_times);
  }

  /// Follows the motion from @p state to the time @p end [s]; @p step [s] is the step tried first, and next.
  YawSample advanced(YawSample state, double end, double &step) const
  {
    constexpr double safety = 0.9, max_growth = 5., max_shrinkage = 0.2;
    constexpr unsigned int max_steps = 100000;
    for (unsigned int n_steps = 0; state.time < end; ++n_steps)
    {
      const bool is_last = state.time + 1.01 * step >= end;
      const double tried = is_last ? end - state.time : step;
      if (n_steps > max_steps || state.time + tried == state.time)
        throw NoBalance(
          sentence("the spin follows its torque with a time constant of ", -yaw_inertia / slopes(state).spin,
                   " s and was not found beyond t = ", state.time, " s; increase the yaw inertia"));
      const Slopes slope = slopes(state);
      const std::optional<YawSample> whole = collocated(state, slope, tried);
      std::optional<YawSample> halves = collocated(state, slope, tried / 2.);
      if (halves)
        halves = collocated(*halves, slope, tried / 2.);
      const double error = whole && halves ? relative_difference(*whole, *halves) : infinity;
      const double growth =
        std::clamp(safety * std::pow(error, -1. / 6.), max_shrinkage, max_growth); // of a local error O(h^6)
      if (error <= 1.)
      {
        state = *halves;
        if (is_last)
          state.time = end;
      }
      if (!is_last || growth < 1.)
        step = tried * growth;
    }
    return state;
  }

private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  /// Derivatives of the torque.
  struct Slopes
  {
    double angle; ///< by the yaw angle [N m]
    double spin;  ///< by the spin [N m s]
  };

  Slopes slopes(const YawSample &at) const
  {
    constexpr double angle_step = 1e-5;
    const double spin_step = 1e-5 * spin_scale;
    return { (torque(at.time, at.yaw_angle + angle_step, at.omega) -
              torque(at.time, at.yaw_angle - angle_step, at.omega)) /
               (2. * angle_step),
             (torque(at.time, at.yaw_angle, at.omega + spin_step) -
              torque(at.time, at.yaw_angle, at.omega - spin_step)) /
               (2. * spin_step) };
  }

  /// Difference of the ends of two steps relative to the requested accuracy.
  double relative_difference(const YawSample &a, const YawSample &b) const
  {
    return std::max(std::abs(a.yaw_angle - b.yaw_angle) / (1. + std::abs(b.yaw_angle)),
                    std::abs(a.omega - b.omega) / (spin_scale + std::abs(b.omega))) /
           accuracy;
  }

  /// The end of one step from @p start; std::nullopt if Newton's method does not converge with the @p slope.
  std::optional<YawSample> collocated(const YawSample &start, const Slopes &slope, double step) const
  {
    static const double root = std::sqrt(6.);
    static const Eigen::Vector3d nodes((4. - root) / 10., (4. + root) / 10., 1.);
    static const Eigen::Matrix3d weights = []
    {
      Eigen::Matrix3d a;
      a << (88. - 7. * root) / 360., (296. - 169. * root) / 1800., (-2. + 3. * root) / 225., //
        (296. + 169. * root) / 1800., (88. + 7. * root) / 360., (-2. - 3. * root) / 225.,    //
        (16. - root) / 36., (16. + root) / 36., 1. / 9.;
      return a;
    }();
    static const Eigen::Matrix3d differences = weights.inverse();
    constexpr unsigned int max_increments = 12;
    const Eigen::Matrix3d inertia = yaw_inertia / step * differences;
    const Eigen::PartialPivLU<Eigen::Matrix3d> newton(inertia - slope.spin * Eigen::Matrix3d::Identity() -
                                                      slope.angle * step * weights);
    Eigen::Vector3d spins = Eigen::Vector3d::Constant(start.omega);
    for (unsigned int n = 0; n < max_increments; ++n)
    {
      const Eigen::Vector3d turned = step * (weights * spins);
      Eigen::Vector3d residual = -inertia * (spins.array() - start.omega).matrix();
      for (unsigned int i = 0; i < 3; ++i)
        residual(i) += torque(start.time + nodes(i) * step, start.yaw_angle + turned(i), spins(i));
      const Eigen::Vector3d increment = newton.solve(residual);
      spins += increment;
      if (!spins.allFinite())
        return std::nullopt;
      if (increment.lpNorm<Eigen::Infinity>() <= 0.03 * accuracy * spin_scale)
        return YawSample{ start.time + step, start.yaw_angle + step * weights.row(2).dot(spins), spins(2) };
    }
    return std::nullopt;
  }

  const PhasedTorqueFunction &torque;
  const double yaw_inertia, accuracy, spin_scale;
};

/// The motion from @p start on, sampled at @p times counted from there: a StiffMotion, or the
/// Dormand-Prince pair with step control and dense output (Boost.Odeint). The torque is never asked for at
/// times beyond the last of @p times.
std::vector<YawSample> motion_from(const YawSample &start, const PhasedTorqueFunction &torque,
                                   double yaw_inertia, const std::vector<double> &times, double accuracy,
                                   double spin_scale)
{
  // The error of one step is held a decade below the request: errors of all steps add up, and the
  // interpolation between steps is one order lower than the steps themselves.
  const double accuracy_of_step = accuracy / 10.;
  const double end = times.empty() ? 0. : times.back();
  const PhasedTorqueFunction until_end = [&](double time, double yaw_angle, double omega)
  { return torque(start.time + std::min(time, end), yaw_angle, omega); };
  const double push = std::abs(until_end(0., start.yaw_angle, start.omega)) / yaw_inertia;
  double first_step = 1e-3 / std::max(push / spin_scale, 1.);

  std::vector<YawSample> samples;
  samples.reserve(times.size());
  const StiffMotion stiff(until_end, yaw_inertia, accuracy_of_step, spin_scale);
  YawSample now = { 0., start.yaw_angle, start.omega };
  if (stiff.is_stiff(now, end, times.size()))
  {
    for (const double time : times)
    {
      now = stiff.advanced(now, time, first_step);
      samples.push_back({ start.time + time, now.yaw_angle, now.omega });
    }
    return samples;
  }

  namespace odeint = boost::numeric::odeint;
  auto stepper =
    odeint::make_dense_output(accuracy_of_step, accuracy_of_step, odeint::runge_kutta_dopri5<YawState>());
  const auto rate_of = [&](const YawState &state, YawState &rate, double time)
  {
    rate[0] = state[1] * spin_scale;
    rate[1] = until_end(time, state[0], rate[0]) / (yaw_inertia * spin_scale);
  };
  const YawState first = { start.yaw_angle, start.omega / spin_scale };
  stepper.initialize(first, 0., first_step);
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
    samples.push_back({ start.time + time, state[0], state[1] * spin_scale });
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
        motion_from(state, torque, yaw_inertia, times, accuracy / 10., spin_scale);
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
