#include "ring_model/terminal_spin.h"

#include "ring_model/failures.h"
#include "ring_model/friction_functionals.h"
#include "ring_model/load/require.h"

#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <utility>

namespace stemware::ring
{
namespace
{
/// Returns the terminal spin @p omega, a zero of @p torque, with the slope of the torque at @p omega.
TerminalSpin described(const TorqueFunction &torque, double yaw_inertia, double omega, double spin_scale)
{
  const double slope = [&]
  {
    const double step = slope_step(omega, spin_scale), narrow = spin_scale / 2048.;
    try
    {
      return torque_slope(torque, omega, step);
    }
    catch (const std::runtime_error &) // the glass tips near omega, but perhaps not within `narrow`
    {
      if (step <= narrow)
        throw;
    }
    return torque_slope(torque, omega, narrow);
  }();
  return { omega, slope, yaw_inertia / std::abs(slope), slope < 0. };
}

using SpinAndTorque = std::pair<double, double>;

/// Returns the zero of @p torque between two spins with torques of opposite signs, to rounding. Throws
/// NoBalance after 200 steps.
double zero_between(const TorqueFunction &torque, const SpinAndTorque &left, const SpinAndTorque &right)
{
  constexpr std::uintmax_t max_steps = 200;
  std::uintmax_t n_steps = max_steps;
  const auto [below, above] =
    boost::math::tools::toms748_solve(torque, left.first, right.first, left.second, right.second,
                                      boost::math::tools::eps_tolerance<double>(52), n_steps);
  if (n_steps >= max_steps)
    throw NoBalance(sentence("the terminal spin between ", left.first, " and ", right.first,
                             " did not converge in ", max_steps, " bracketing steps"));
  return std::abs(torque(below)) <= std::abs(torque(above)) ? below : above;
}
} // namespace

double slope_step(double omega, double spin_scale)
{
  const double to_bend = std::abs(std::abs(omega) - spin_scale);
  return std::clamp(to_bend / 32., spin_scale / 4096., spin_scale / 64.);
}

double slope_of_differences(double change, double change_of_two_steps, double step)
{
  return (8. * change - change_of_two_steps) / (12. * step);
}

double torque_slope(const TorqueFunction &torque, double omega, double step)
{
  const auto change = [&](double reach) { return torque(omega + reach) - torque(omega - reach); };
  return slope_of_differences(change(step), change(2. * step), step);
}

TerminalSpin terminal_spin(const TorqueFunction &torque, double yaw_inertia, const SpinSearch &search)
{
  require_positive(yaw_inertia, "the yaw inertia", "kg m^2");
  const TerminalSpin zero = find_terminal_spin(torque, search);
  return zero.held ? zero : described(torque, yaw_inertia, zero.omega, search.spin_scale);
}

std::optional<TerminalSpin> find_terminal_spin_near(const TerminalSpin &known, const TorqueFunction &torque,
                                                    const SpinSearch &search)
{
  constexpr unsigned int max_steps = 8;
  constexpr double neighbourhood = 0.1; // maximum distance of an iterate from `known`, over the spin scale
  constexpr double nearly = 1e-7;       // maximum relative length of the last step (without a new torque)
  constexpr double of_another = 0.1;    // assumed relative error of `known.torque_slope`
  const double grip = std::copysign(search.grip_torque, known.omega);
  const double scale = std::max(std::abs(known.omega), SpinSearch::least_size * search.spin_scale);
  double spin = known.omega, slope = known.torque_slope, slope_error = of_another;
  double value = torque(spin) - grip;
  for (unsigned int n = 0; n < max_steps; ++n)
  {
    const double step = -value / slope, next = spin + step;
    if (std::abs(step) <= nearly * scale && slope_error * std::abs(step) <= search.tolerance * scale)
    {
      if (search.stability_margin && search.stability_margin(spin) < SpinSearch::unsteady)
        return std::nullopt;
      return TerminalSpin{ next, slope, NAN, true, false, spin };
    }
    if (!(std::abs(next - known.omega) <= neighbourhood * search.spin_scale))
      return std::nullopt;
    const double next_value = torque(next) - grip;
    const double secant = (next_value - value) / step;
    if (std::abs(step) > SpinSearch::rounding_distance * search.spin_scale)
    {
      slope = secant;
      slope_error = std::clamp(10 * std::abs(step) / search.spin_scale, 1e-3, of_another);
    }
    if (!(slope < 0))
      return std::nullopt;
    spin = next;
    value = next_value;
  }
  return std::nullopt;
}

TerminalSpin terminal_spin(const RingStack &load, const Motion &motion)
{
  motion.validate();
  SpinSearch search{ motion.orbit_speed / load.radius() };
  search.tolerance = std::numeric_limits<double>::epsilon();
  return terminal_spin([&](double omega) { return wrench(motion, load, omega).torque; }, motion.yaw_inertia,
                       search);
}

std::vector<TerminalSpin> all_terminal_spins(const TorqueFunction &torque, double yaw_inertia,
                                             double spin_scale, double lower, double upper,
                                             unsigned int n_intervals)
{
  require_positive(yaw_inertia, "the yaw inertia", "kg m^2");
  require(std::isfinite(lower) && std::isfinite(upper) && lower < upper && n_intervals > 0,
          "the range of spins is ", lower, " to ", upper, " rad/s in ", n_intervals,
          " intervals, but must be finite and not empty");
  const auto spin = [&](unsigned int i) { return lower + (upper - lower) * i / n_intervals; };
  std::vector<SpinAndTorque> samples;
  for (unsigned int i = 0; i <= n_intervals; ++i)
    samples.emplace_back(spin(i), torque(spin(i)));

  // The torque may change its sign twice near a sample of locally minimum |torque|, so the extremum is added.
  for (unsigned int i = 1; i < n_intervals; ++i)
  {
    const double sign = samples[i].second < 0. ? -1. : 1.;
    const auto height = [&](double omega) { return sign * torque(omega); };
    const double here = sign * samples[i].second;
    if (here < sign * samples[i - 1].second && here <= sign * samples[i + 1].second)
    {
      const auto [dip, least] = boost::math::tools::brent_find_minima(
        height, spin(i - 1), spin(i + 1), std::numeric_limits<double>::digits / 2);
      samples.emplace_back(dip, sign * least);
    }
  }
  std::sort(samples.begin(), samples.end());

  std::vector<TerminalSpin> spins;
  const auto add = [&](double omega) { spins.push_back(described(torque, yaw_inertia, omega, spin_scale)); };
  for (std::size_t i = 0; i + 1 < samples.size(); ++i)
    if (samples[i].second == 0.)
      add(samples[i].first);
    else if (samples[i].second * samples[i + 1].second < 0.)
      add(zero_between(torque, samples[i], samples[i + 1]));
  if (samples.back().second == 0.)
    add(upper);
  return spins;
}
} // namespace stemware::ring
