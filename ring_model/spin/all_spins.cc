#include "ring_model/failures.h"
#include "ring_model/friction_functionals.h"
#include "ring_model/spin/curves.h"
#include "ring_model/yaw_motion.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stemware::ring
{

namespace
{

/// Returns the largest n <= @p n_most for which the load has a balance at the spins step, 2 step, ..., n
/// step. Only every @p stride-th spin is tested until a balance is missing, then every spin.
int n_balances(const Load &load, double step, int stride, int n_most)
{
  int n_found = 0;
  const auto goes_on = [&](int n) { return find_or_nullopt([&] { return load.at((n_found + n) * step); }); };
  for (const int n : { stride, 1 })
    while (n_found + n <= n_most && goes_on(n))
      n_found += n;
  return n_found;
}

struct Reach
{
  double step; ///< [rad/s]
  int n_steps, stride;
};

/// Returns true if friction brakes at @p omega and at all higher spins with more than ten times the lean
/// torque. If every rim point turns faster than the glass travels (eps = |omega| r / v > 1), friction brakes
/// at every point with an arm of at least sqrt(1 - 1 / eps^2) r. This holds for any load without tension.
bool brakes_beyond(double omega, const Load &load, const Motion &motion)
{
  constexpr double much = 10;
  const Sample at_spin = load.at(omega);
  double radius = at_spin.radius();
  for (const auto &ring : at_spin.rings())
    radius = std::min(radius, ring.radius);
  const double eps = std::abs(omega) * radius / motion.orbit_speed;
  if (!load.is_pressure() || !motion.has_constant_friction() || eps <= 1)
    return false;
  const double min_torque =
    std::sqrt(1 - 1 / (eps * eps)) * motion.friction_at_rest() * motion.normal_force() * radius;
  return much * std::abs(at_spin.lean_torque()) < min_torque;
}

/// Returns the range of spins in which friction may drive the glass. It ends at 1.5 v / R if, in at least one
/// direction, the balance exists up to 1.05 v / R and brakes_beyond() is false at this spin. Otherwise it
/// ends at 1.05 v / R.
Reach reach_of(const Load &load, const Motion &motion)
{
  const double unit = load.spin_scale(motion);
  const Reach near = { 1.05 * unit / 4, 4, 2 }, far = { unit / 4, 6, 3 };
  for (const double direction : { -1., 1. })
    if (n_balances(load, direction * near.step, near.stride, near.n_steps) == near.n_steps &&
        !brakes_beyond(direction * near.n_steps * near.step, load, motion))
      return far;
  return near;
}

} // namespace

std::vector<TerminalSpin> terminal_spins(const Load &load, const Question &question, const Answer &found)
{
  if (load.phases() || !found.terminal)
    return {};
  constexpr int intervals_per_step = 8;
  const Motion &motion = question.motion;
  const double unit = load.spin_scale(motion);
  const auto [step, n_steps, stride] = reach_of(load, motion);
  const int first = -n_balances(load, -step, stride, n_steps), last = n_balances(load, step, stride, n_steps);
  if (first == last)
    return { *found.terminal };
  const auto spins_under = [&](const Load &at_spins, double lower, double upper, int n_intervals)
  {
    const auto torque = [&](double omega)
    {
      const double free = yaw_torque(at_spins, motion, omega);
      return free + grip_torque(free, omega, question.grip_torque);
    };
    return all_terminal_spins(torque, motion.yaw_inertia, unit, lower, upper,
                              static_cast<unsigned int>(n_intervals));
  };
  // Contact solves are costly, so zeros of the torque are found with a coarsely interpolated load and refined
  // with `load`.
  double reach = 1e-4 * unit;
  const auto scan = [&, step = step]
  {
    const Load curve = load.interpolated(first * step, last * step, { 3e-3, 3e-3, 8, 60 });
    const double error = curve.interpolation_error().value_or(0);
    reach = std::max(1e-4, 10 * error) * unit;
    std::vector<TerminalSpin> scanned =
      spins_under(curve, first * step, last * step, intervals_per_step * (last - first));
    if (error == 0)
      return scanned;
    std::vector<TerminalSpin> spins;
    for (const TerminalSpin &near : scanned)
      if (std::abs(near.omega - found.terminal->omega) >= reach)
        for (const TerminalSpin &spin : spins_under(load, near.omega - reach, near.omega + reach, 2))
          spins.push_back(spin);
    return spins;
  };
  std::vector<TerminalSpin> spins = find_or_nullopt(scan).value_or(std::vector<TerminalSpin>());
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  for (TerminalSpin &spin : spins)
    if (question.grip_torque > 0 && std::abs(spin.omega) < 1e-9 * unit)
      spin = { 0, nan, nan, true, true };
  spins.erase(std::remove_if(spins.begin(), spins.end(),
                             [&](const TerminalSpin &spin)
                             { return std::abs(spin.omega - found.terminal->omega) < reach; }),
              spins.end());
  spins.push_back(*found.terminal);
  std::sort(spins.begin(), spins.end(),
            [](const TerminalSpin &a, const TerminalSpin &b) { return a.omega < b.omega; });
  return spins;
}
} // namespace stemware::ring
