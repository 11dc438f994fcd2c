#include "ring_model/terminal_spin.h"

#include "ring_model/friction_law.h"
#include "ring_model/load/require.h"
#include "ring_model/no_balance.h"

#include <boost/math/differentiation/finite_difference.hpp>
#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace stemware::ring
{
namespace
{
/// The zero between two spins, in either order, with torques of opposite sign.
double bracketed_zero(const TorqueFunction &torque, double lower, double upper, double torque_lower,
                      double torque_upper)
{
  if (lower > upper)
    return bracketed_zero(torque, upper, lower, torque_upper, torque_lower);
  if (torque_lower == 0.)
    return lower;
  if (torque_upper == 0.)
    return upper;
  std::uintmax_t n_iterations = 200;
  const auto bracket =
    boost::math::tools::toms748_solve(torque, lower, upper, torque_lower, torque_upper,
                                      boost::math::tools::eps_tolerance<double>(52), n_iterations);
  if (n_iterations >= 200)
    throw NoBalance(sentence("the terminal spin between ", lower, " and ", upper,
                             " rad/s did not converge in 200 bracketing steps"));
  return std::abs(torque(bracket.first)) < std::abs(torque(bracket.second)) ? bracket.first : bracket.second;
}

TerminalSpin describe(const TorqueFunction &torque, double yaw_inertia, double omega, double unit)
{
  // Differences of eighth order with steps of about 1/30 unit.
  const auto scaled = [&](double spin) { return torque(spin * unit); };
  const double slope =
    boost::math::differentiation::finite_difference_derivative<decltype(scaled), double, 8>(scaled,
                                                                                            omega / unit) /
    unit;
  return { omega, slope, yaw_inertia / std::abs(slope), slope < 0. };
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
  const SpinZero zero = find_terminal_spin(torque, search);
  if (zero.held)
    return { 0., std::nan(""), std::nan(""), true, true };
  const double slope = [&]
  {
    const double step = slope_step(zero.omega, search.spin_scale), narrow = search.spin_scale / 2048.;
    try
    {
      return torque_slope(torque, zero.omega, step);
    }
    catch (const std::runtime_error &) // a fall nearby, which a narrower step may not reach
    {
      if (step <= narrow)
        throw;
    }
    return torque_slope(torque, zero.omega, narrow);
  }();
  return { zero.omega, slope, yaw_inertia / std::abs(slope), slope < 0. };
}

TerminalSpin terminal_spin(const TorqueFunction &torque, double yaw_inertia, double spin_scale)
{
  require_positive(yaw_inertia, "the yaw inertia", "kg m^2");
  SpinSearch search{ spin_scale };
  search.tolerance = std::numeric_limits<double>::epsilon();
  return describe(torque, yaw_inertia, find_terminal_spin(torque, search).omega, spin_scale / 8.);
}

TerminalSpin terminal_spin(const RingStack &load, const Motion &motion)
{
  motion.validate();
  return terminal_spin([&](double omega) { return wrench(motion, load, omega).torque; }, motion.yaw_inertia,
                       motion.orbit_speed / load.radius());
}

std::vector<TerminalSpin> all_terminal_spins(const TorqueFunction &torque, double yaw_inertia, double lower,
                                             double upper, unsigned int n_intervals)
{
  require_positive(yaw_inertia, "the yaw inertia", "kg m^2");
  require(std::isfinite(lower) && std::isfinite(upper) && lower < upper && n_intervals > 0,
          "the range of spins is ", lower, " to ", upper, " rad/s in ", n_intervals,
          " intervals, but must be finite and not empty");
  const auto spin = [&](unsigned int i) { return lower + (upper - lower) * i / n_intervals; };
  std::vector<std::pair<double, double>> samples;
  for (unsigned int i = 0; i <= n_intervals; ++i)
    samples.emplace_back(spin(i), torque(spin(i)));

  // Where |torque| dips without a change of sign, its least value is made a sample: it may lie on the other
  // side.
  for (unsigned int i = 1; i < n_intervals; ++i)
  {
    const double sign = samples[i].second < 0. ? -1. : 1.;
    const auto height = [&](double omega) { return sign * torque(omega); };
    const double here = sign * samples[i].second;
    if (here < sign * samples[i - 1].second && here <= sign * samples[i + 1].second)
      samples.push_back(
        [&]
        {
          const auto dip = boost::math::tools::brent_find_minima(height, spin(i - 1), spin(i + 1),
                                                                 std::numeric_limits<double>::digits / 2);
          return std::make_pair(dip.first, sign * dip.second);
        }());
  }
  std::sort(samples.begin(), samples.end());

  std::vector<TerminalSpin> spins;
  const double unit = (upper - lower) / 256.;
  for (std::size_t i = 0; i + 1 < samples.size(); ++i)
  {
    const auto &[left, torque_left] = samples[i];
    const auto &[right, torque_right] = samples[i + 1];
    if (torque_left == 0. || torque_left * torque_right < 0.)
      spins.push_back(
        describe(torque, yaw_inertia, bracketed_zero(torque, left, right, torque_left, torque_right), unit));
  }
  if (samples.back().second == 0.)
    spins.push_back(describe(torque, yaw_inertia, upper, unit));
  return spins;
}
} // namespace stemware::ring
