#include "ring_model/friction_functionals.h"
#include "ring_model/if_balanced.h"
#include "ring_model/spin/curves.h"
#include "ring_model/yaw_motion.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace stemware::ring
{

namespace
{

/// A torque to be scanned for its zeros. A load takes a contact, and far from a zero need not be known well:
/// where the load halfway between two spins tells that one between theirs can be off by less than a third of
/// the torque, a load between theirs does.
class ScannedTorque
{
public:
  /// Spins are told apart down to @p finest [rad/s].
  ScannedTorque(const Load &load, const Motion &motion, double grip_torque, double finest)
      : load(load)
      , motion(motion)
      , grip_torque(grip_torque)
      , finest(finest)
      , unit(motion.friction_at_rest() * motion.normal_force() * load.radius())
  {
  }

  double operator()(double omega)
  {
    const auto piece = pieces.lower_bound(omega);
    if (piece != pieces.end() && piece->second.first <= omega)
      return torque_of(between(piece->second.first, piece->first, omega), omega);
    return torque_of(at(omega), omega);
  }

  /// Looks for the pieces of @p lower to @p upper where a load between them does.
  void survey(double lower, double upper)
  {
    const double middle = (lower + upper) / 2;
    constexpr double safety = 3, of_halves = 1. / 4; // the error falls with the square of the length
    const double error = safety * of_halves * unit * between(lower, upper, middle).difference(at(middle));
    for (const auto &[begin, end] : { std::pair(lower, middle), std::pair(middle, upper) })
      if (keeps_off_zero(begin, end, error))
        pieces.emplace(end, std::make_pair(begin, end));
      else if (end - begin > 1.5 * finest)
        survey(begin, end);
  }

private:
  /// Whether the torque of the loads between those at @p lower and @p upper is everywhere of one sign and
  /// more than @p error.
  bool keeps_off_zero(double lower, double upper, double error)
  {
    const int n_parts = static_cast<int>(std::ceil((upper - lower) / finest));
    double least = std::numeric_limits<double>::infinity(), most = -least;
    for (int i = 0; i <= n_parts; ++i)
    {
      const double omega = lower + (upper - lower) * i / n_parts;
      const double torque = torque_of(between(lower, upper, omega), omega);
      least = std::min(least, torque);
      most = std::max(most, torque);
    }
    return least > error || most < -error;
  }

  const Sample &at(double omega)
  {
    const double rounding = 1e-9 * finest;
    const auto known = loads.lower_bound(omega - rounding);
    return known != loads.end() && known->first <= omega + rounding
             ? known->second
             : loads.emplace(omega, load.at(omega)).first->second;
  }

  Sample between(double lower, double upper, double omega)
  {
    const Sample &below = at(lower), &above = at(upper);
    const unsigned int n = std::max(below.n_harmonics(), above.n_harmonics());
    const double share = (omega - lower) / (upper - lower);
    const Eigen::VectorXd row = (1 - share) * below.coefficients(n) + share * above.coefficients(n);
    return Sample::from_coefficients(row, below.rings().size());
  }

  double torque_of(const Sample &at_spin, double omega) const
  {
    const double torque = wrench(motion, at_spin, omega).torque + at_spin.lean_torque();
    return torque_with_grip(torque, omega, grip_torque);
  }

  const Load &load;
  const Motion &motion;
  const double grip_torque;
  const double finest;
  const double unit; ///< mu N R [N m]: what an error of the load of a_0 makes of the torque at most
  std::map<double, Sample> loads;
  std::map<double, std::pair<double, double>> pieces; ///< by their end
};

/// How many of at most @p n_most steps of @p step from rest have a torque, tried in strides of @p stride.
int n_balances(ScannedTorque &torque, double step, int stride, int n_most)
{
  int n_found = 0;
  const auto goes_on = [&](int n) { return if_balanced([&] { return torque((n_found + n) * step); }); };
  for (const int n : { stride, 1 })
    while (n_found + n <= n_most && goes_on(n))
      n_found += n;
  return n_found; // the load tips or has no balance there: nothing lies beyond
}

/// How far from rest spins are looked for: so many steps, tried several at once.
struct Reach
{
  double step; ///< [rad/s]
  int n_steps, stride;
};

/// Whether friction brakes at @p omega and beyond by much more than the lean of the glass could drive it.
/// Where all of the rim turns faster than it travels, eps = |omega| r / v > 1, friction brakes each place of
/// it, and its arm is no less than sqrt(1 - 1 / eps^2) r: so it does under any load that nowhere pulls, such
/// as a contact's.
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

/// To where friction brakes, or the load has no balance, whatever its distribution; else to 1.5 v / R.
Reach reach_of(ScannedTorque &torque, const Load &load, const Motion &motion)
{
  const double unit = load.spin_scale(motion);
  const Reach near = { 1.05 * unit / 4, 4, 2 }, far = { unit / 4, 6, 3 };
  for (const double direction : { -1., 1. })
    if (n_balances(torque, direction * near.step, near.stride, near.n_steps) == near.n_steps &&
        !brakes_beyond(direction * near.n_steps * near.step, load, motion))
      return far;
  return near;
}

} // namespace

std::vector<TerminalSpin> terminal_spins(const Load &load, const Question &question, const Answer &found)
{
  if (load.phases() || !found.terminal)
    return {};
  constexpr int finest_steps = 8;
  const Motion &motion = question.motion;
  const double unit = load.spin_scale(motion);
  ScannedTorque torque(load, motion, question.grip_torque, unit / 4 / finest_steps);
  const auto [step, n_steps, stride] = reach_of(torque, load, motion);
  const int first = -n_balances(torque, -step, stride, n_steps),
            last = n_balances(torque, step, stride, n_steps);
  const auto scan = [&, step = step]
  {
    if (first < 0)
      torque.survey(first * step, 0);
    if (last > 0)
      torque.survey(0, last * step);
    return all_terminal_spins([&](double omega) { return torque(omega); }, motion.yaw_inertia, unit,
                              first * step, last * step,
                              static_cast<unsigned int>(finest_steps * (last - first)));
  };
  // A load without a balance between spins that have one: what lies beyond is not looked for.
  std::vector<TerminalSpin> spins;
  if (first < last)
    spins = if_balanced(scan).value_or(spins);
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  for (TerminalSpin &spin : spins)
    if (question.grip_torque > 0 && std::abs(spin.omega) < 1e-9 * unit)
      spin = { 0, nan, nan, true, true };
  // The spin that is reached from rest is known better.
  const double same = std::max(1e-4, 10 * load.interpolation_error().value_or(0)) * unit;
  spins.erase(std::remove_if(spins.begin(), spins.end(),
                             [&](const TerminalSpin &spin)
                             { return std::abs(spin.omega - found.terminal->omega) < same; }),
              spins.end());
  spins.push_back(*found.terminal);
  std::sort(spins.begin(), spins.end(),
            [](const TerminalSpin &a, const TerminalSpin &b) { return a.omega < b.omega; });
  return spins;
}
} // namespace stemware::ring
