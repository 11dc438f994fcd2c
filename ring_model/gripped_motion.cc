#include "ring_model/failures.h"
#include "ring_model/load/require.h"
#include "ring_model/yaw_motion.h"

#include <Eigen/Dense>
#include <boost/math/tools/toms748_solve.hpp>
#include <boost/numeric/odeint/algebra/array_algebra.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

namespace stemware::ring
{
namespace
{
/// Motion of a spin that follows its torque so fast that an explicit method needs steps below its time
/// constant. Three-stage Radau IIA, order 5; without inertia each stage is a zero of the torque (Hairer &
/// Wanner, Solving Ordinary Differential Equations II, IV.5).
class StiffMotion
{
public:
  /// For the arguments see yaw_motion().
  StiffMotion(PhasedTorqueFunction torque, double yaw_inertia, double accuracy, double spin_scale)
      : torque(std::move(torque))
      , yaw_inertia(yaw_inertia)
      , accuracy(accuracy)
      , spin_scale(spin_scale)
  {
  }

  /// Returns whether few steps, between @p n_times outputs until @p end [s], cost less than explicit steps.
  bool is_stiff(const YawSample &start, double end, std::size_t n_times) const
  {
    // Number of time constants per output above which implicit steps are cheaper: an implicit step costs
    // about 30 torque evaluations, and stable explicit steps need about two evaluations per time constant.
    constexpr double min_time_constants = 20.;
    // The torque may jump at spin 0, so the slope is taken on the side towards which the glass turns.
    YawSample beside = start;
    beside.omega += std::copysign(2e-5 * spin_scale, torque(start.time, start.yaw_angle, start.omega));
    return -slopes(beside).spin / yaw_inertia * end > min_time_constants * static_cast<double>(n_times);
  }

  /// Returns the state after one step from @p state, not beyond the time @p end [s]. @p step [s]: first
  /// trial, overwritten by the next trial. Throws NoBalance if no step is small enough.
  YawSample after_step(const YawSample &state, double end, double &step) const
  {
    constexpr double safety = 0.9, max_growth = 5., max_shrinkage = 0.2;
    for (;;)
    {
      const bool is_last = state.time + 1.01 * step >= end;
      const double tried = is_last ? end - state.time : step;
      const Slopes slope = slopes(state);
      if (state.time + tried == state.time)
        throw NoBalance(sentence("the spin follows its torque with a time constant of ",
                                 -yaw_inertia / slope.spin, " s and was not found beyond t = ", state.time,
                                 " s; increase the yaw inertia"));
      const std::optional<YawSample> whole = collocated(state, slope, tried);
      std::optional<YawSample> halves = collocated(state, slope, tried / 2.);
      if (halves)
        halves = collocated(*halves, slope, tried / 2.);
      const double error =
        whole && halves ? relative_difference(*whole, *halves) : std::numeric_limits<double>::infinity();
      const double growth =
        std::clamp(safety * std::pow(error, -1. / 6.), max_shrinkage, max_growth); // local error O(h^6)
      if (!is_last || growth < 1.)
        step = tried * growth;
      if (error > 1.)
        continue;
      if (is_last)
        halves->time = end;
      return *halves;
    }
  }

  /// Returns the state one step of @p step [s] after @p state, without an estimate of its error. Throws
  /// NoBalance if the step is not found.
  YawSample within_step(const YawSample &state, double step) const
  {
    const std::optional<YawSample> found = collocated(state, slopes(state), step);
    if (!found)
      throw NoBalance(sentence("the spin was not found beyond t = ", state.time, " s"));
    return *found;
  }

private:
  /// Derivatives of the torque.
  struct Slopes
  {
    double angle; ///< derivative with respect to the yaw angle [N m]
    double spin;  ///< derivative with respect to the spin [N m s]
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

  /// Returns the difference of the ends of two steps relative to the requested accuracy.
  double relative_difference(const YawSample &a, const YawSample &b) const
  {
    return std::max(std::abs(a.yaw_angle - b.yaw_angle) / (1. + std::abs(b.yaw_angle)),
                    std::abs(a.omega - b.omega) / (spin_scale + std::abs(b.omega))) /
           accuracy;
  }

  /// Returns one step from @p start; std::nullopt if Newton's method with @p slope does not converge.
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

  const PhasedTorqueFunction torque;
  const double yaw_inertia, accuracy, spin_scale;
};

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
    for (unsigned int n = 0;; ++n)
    {
      add_due();
      if (samples.size() == times.size())
        return std::move(samples);
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

  void add_due()
  {
    while (is_due(now.time))
      add(now);
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
    for (; samples.size() < wanted->size(); add_due())
    {
      const double next = std::min({ (*wanted)[samples.size()], next_break(now.time), now.time + look });
      if (excess(next) > 0.)
      {
        // The excess may be exactly 0 at now.time, so the bracket begins slightly later.
        const double first = now.time + 1e-9 * (next - now.time);
        now.time = excess(first) < 0. ? end_of(excess, first, next) : first;
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
} // namespace

std::vector<YawSample> gripped_motion(const YawSample &start, const PhasedTorqueFunction &torque,
                                      double yaw_inertia, const std::vector<double> &times, double accuracy,
                                      double spin_scale, double grip, const std::vector<double> &breaks)
{
  // The tolerance of a step is a tenth of the accuracy, because step errors accumulate and the dense output
  // is one order less accurate than the steps.
  return GrippedMotion(torque, yaw_inertia, accuracy / 10., spin_scale, grip, breaks).from(start, times);
}
} // namespace stemware::ring
