#include "ring_model/spin_search.h"

#include "ring_model/load/lagrange.h"
#include "ring_model/load/require.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <exception>
#include <iterator>
#include <map>
#include <vector>

namespace stemware::ring
{
namespace
{
// Spins below are in units of the spin scale v / R, over which the friction torque varies.
constexpr double farthest = 64.;       ///< end of the search
constexpr double first_step = 1. / 4.; ///< first spin without an initial guess
/// Width below which an interval is not bisected any more; it bounds the error of BalanceLost::last_spin.
constexpr double shortest_interval = 1. / 4096.;
constexpr double scan_step = 1. / 16.; ///< step of a scan; two closer zeros may be missed
/// Minimum distance of two spins from which a slope of the stability margin is computed. First: near the spin
/// at which the balance ends; second: between rest and the zero.
constexpr double margin_distance = 1. / 1024., margin_distance_on_the_way = 1. / 8192.;

/// Maximum ratio between the slope at the zero and the mean slope from rest to the zero (in either order). A
/// larger ratio suggests an earlier zero between the samples.
constexpr double steepness_ratio = 16.;
constexpr unsigned int max_evaluations = 200; ///< per search; prevents endless cycles

/// Driving torque at a spin; both are positive in the direction of the torque at rest.
struct DrivingTorque
{
  double spin;   ///< > 0 [rad/s]
  double torque; ///< tau_z - tau_g [N m], positive before the zero
};

/// Returns whether the torque of @p one is closer to zero.
bool has_smaller_torque(const DrivingTorque &one, const DrivingTorque &other)
{
  return std::abs(one.torque) < std::abs(other.torque);
}

/// Estimate of the spin at which the torque vanishes.
struct Estimate
{
  double spin;  ///< estimate by the polynomial spin(torque) through at most four samples
  double error; ///< difference to the estimate without the farthest sample
};

/// Returns the estimate from the one to four @p samples (not empty) of smallest |torque| between which the
/// torque decreases with the spin; more would add rounding only. The error from one sample is HUGE_VAL.
Estimate inverse_interpolation(std::vector<DrivingTorque> samples)
{
  std::sort(samples.begin(), samples.end(), has_smaller_torque);
  const auto falls = [&](std::size_t n)
  {
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (!((samples[i].torque - samples[j].torque) * (samples[i].spin - samples[j].spin) < 0.))
          return false;
    return true;
  };
  std::size_t n = std::min<std::size_t>(samples.size(), 4); // a cubic
  while (!falls(n))
    --n;
  const auto through = [&](std::size_t n_used)
  {
    Eigen::VectorXd torques(n_used), distances(n_used); // relative to the spin of the smallest torque
    for (std::size_t i = 0; i < n_used; ++i)
    {
      torques(i) = samples[i].torque;
      distances(i) = samples[i].spin - samples.front().spin;
    }
    return samples.front().spin + lagrange_values(torques, 0.).dot(distances);
  };
  return n < 2 ? Estimate{ through(1), HUGE_VAL }
               : Estimate{ through(n), std::abs(through(n) - through(n - 1)) };
}

[[noreturn]] void throw_balance_lost(const std::exception_ptr &failure, double last)
{
  try
  {
    std::rethrow_exception(failure);
  }
  catch (const NoBalance &cause)
  {
    std::throw_with_nested(BalanceLost(sentence("the balance is lost at ", last + 0.,
                                                " rad/s, before a terminal spin is reached: ", cause.what()),
                                       last, cause.tips()));
  }
}

/// Search from rest for the first zero of the driving torque. Spins are positive in the driving direction.
class OutwardSearch
{
public:
  /// Preconditions: @p torque_at_rest = @p driving_torque(0) > 0, and @p direction is the sign of the spin, 1
  /// or -1. References to @p driving_torque and @p search are kept.
  OutwardSearch(const std::function<double(double)> &driving_torque, double torque_at_rest, double direction,
                const SpinSearch &search)
      : driving_torque(driving_torque)
      , direction(direction)
      , search(search)
      , samples{ { 0., torque_at_rest } }
  {
  }

  /// Returns the zero nearest to rest, searched from the spin @p first > 0. Throws like find_terminal_spin().
  double zero(double first)
  {
    double spin = converge(samples.front(), first, {});
    if (needs_scan(spin))
      spin = scanned(spin);
    if (search.stability_margin)
      spin = reached(spin);
    if (const std::optional<double> fall =
          search.nearest_unbalanced_spin ? search.nearest_unbalanced_spin(direction * spin) : std::nullopt)
      spin = converge(nearest_before(std::abs(*fall)), std::abs(*fall), {});
    return spin;
  }

private:
  /// Returns a zero between @p near (positive driving torque) and, if given, @p far (negative driving
  /// torque). The first sample is @p proposal, which lies between @p near and @p far.
  double converge(DrivingTorque near, double proposal, std::optional<DrivingTorque> far)
  {
    std::vector<DrivingTorque> used{ near };
    if (far)
      used.push_back(*far);
    std::exception_ptr failure; // exception thrown by the torque at the spin `barrier`
    double barrier = 0.;
    double width = HUGE_VAL;
    bool may_extrapolate = true;
    for (unsigned int i = 0; i < max_evaluations; ++i)
    {
      const double least = std::abs(std::min_element(used.begin(), used.end(), has_smaller_torque)->torque);
      bool halved = true;
      if (const std::optional<DrivingTorque> sample = sample_at(proposal, &failure))
      {
        used.push_back(*sample);
        if (sample->torque == 0.)
          return sample->spin;
        halved = used.size() <= 2 || std::abs(sample->torque) <= 0.5 * least;
        if (sample->torque > 0.)
          near = *sample;
        else
        {
          far = sample;
          failure = nullptr;
        }
      }
      else
      {
        barrier = proposal;
        far.reset();
        used.erase(std::remove_if(used.begin(), used.end(),
                                  [&](const DrivingTorque &other) { return other.spin > proposal; }),
                   used.end());
      }
      const Estimate estimate = inverse_interpolation(used);
      const double tolerance =
        search.tolerance * std::max(estimate.spin, SpinSearch::least_size * search.spin_scale);
      if (estimate.error <= tolerance && !(failure && estimate.spin >= barrier))
        return estimate.spin;
      if (far && far->spin - near.spin <= tolerance)
        return (near.spin + far->spin) / 2.;
      if (failure && barrier - near.spin < shortest_interval * search.spin_scale)
        throw_balance_lost(failure, direction * near.spin);
      proposal = next(estimate, near.spin, far ? &far->spin : failure ? &barrier : nullptr, halved);
      if (failure && !(near.spin < estimate.spin && estimate.spin < barrier))
      {
        may_extrapolate = !may_extrapolate || barrier - near.spin < 0.5 * width;
        width = barrier - near.spin;
        if (may_extrapolate)
          proposal = next_to_the_end(near.spin, barrier).value_or(proposal);
      }
    }
    throw NoBalance(sentence("the terminal spin did not converge in ", max_evaluations,
                             " evaluations of the torque, the last one at ", proposal, " rad/s"));
  }

  /// Returns the driving torque at @p spin. Without balance, returns std::nullopt and sets @p failure.
  std::optional<DrivingTorque> sample_at(double spin, std::exception_ptr *failure = nullptr)
  {
    try
    {
      return samples.emplace_back(DrivingTorque{ spin, driving_torque(spin) });
    }
    catch (const NoBalance &)
    {
      if (failure)
        *failure = std::current_exception();
      return std::nullopt;
    }
  }

  /// Returns the next spin to sample, between @p near and @p end: the @p estimate if the last sample at least
  /// halved the smallest torque (@p halved), otherwise the middle. Without an @p end, the step is at most 2
  /// max(near, first_step). Throws NoTerminalSpin at the end of the search.
  double next(const Estimate &estimate, double near, const double *end, bool halved) const
  {
    const double reach = end ? *end : near + 2. * std::max(near, first_step * search.spin_scale);
    const bool inside = near < estimate.spin && estimate.spin < reach;
    if (inside && (halved || !end))
      return estimate.spin;
    if (end)
      return (near + *end) / 2.;
    if (near >= farthest * search.spin_scale)
      throw NoTerminalSpin(sentence("no terminal spin: from rest to ", near,
                                    " rad/s the torque that drives the spin does not vanish"));
    return std::min(reach, farthest * search.spin_scale);
  }

  /// Returns a spin close to the end of the balance, which lies between @p near (balance) and @p barrier (no
  /// balance). Near its end the square of the stability margin is nearly linear in the spin, so it is
  /// extrapolated to 0. Returns std::nullopt if the margin does not decrease.
  std::optional<double> next_to_the_end(double near, double barrier) const
  {
    if (!search.stability_margin)
      return std::nullopt;
    const double narrowest = margin_distance * search.spin_scale;
    double before = -1.;
    for (const DrivingTorque &sample : samples)
      if (sample.spin < near - narrowest && sample.spin > before)
        before = sample.spin;
    if (before < 0.)
      return std::nullopt;
    const auto square = [&](double spin) { return std::pow(search.stability_margin(direction * spin), 2); };
    const double left = square(before), right = square(near);
    if (!(right < left))
      return std::nullopt;
    const double end = near + right * (near - before) / (left - right);
    const double width = barrier - near, enough = shortest_interval * search.spin_scale;
    if (end - near < 0.5 * enough)
      return near + std::min(0.9 * enough, 0.5 * width);
    return std::clamp(end - 0.3 * enough, near + 0.05 * width, barrier - 0.05 * width);
  }

  /// Returns true if an earlier zero than the zero at @p spin is possible: the torque does not decrease
  /// monotonically, or its slope at the zero and its mean slope differ by more than the factor
  /// steepness_ratio.
  bool needs_scan(double spin)
  {
    std::vector<DrivingTorque> way;
    std::copy_if(samples.begin(), samples.end(), std::back_inserter(way),
                 [&](const DrivingTorque &sample) { return sample.spin < spin; });
    if (std::none_of(way.begin(), way.end(),
                     [&](const DrivingTorque &sample)
                     { return sample.spin > 0.2 * spin && sample.spin < 0.8 * spin; }))
    {
      const std::optional<DrivingTorque> halfway = sample_at(0.5 * spin);
      if (!halfway)
        return true;
      way.push_back(*halfway);
    }
    std::sort(way.begin(), way.end(),
              [](const DrivingTorque &a, const DrivingTorque &b) { return a.spin < b.spin; });
    for (std::size_t i = 1; i < way.size(); ++i)
      if (way[i].torque >= way[i - 1].torque)
        return true;
    const double too_close = SpinSearch::rounding_distance * search.spin_scale;
    const DrivingTorque *nearest = nullptr;
    for (const DrivingTorque &sample : samples)
      if (std::abs(sample.spin - spin) > too_close &&
          (!nearest || std::abs(sample.spin - spin) < std::abs(nearest->spin - spin)))
        nearest = &sample;
    if (!nearest)
      return false;
    const double mean = samples.front().torque / spin;
    const double local = nearest->torque / (spin - nearest->spin);
    return !(local * steepness_ratio > mean && local < steepness_ratio * mean);
  }

  /// Returns the first zero up to the zero at @p spin. Throws BalanceLost if the balance ends earlier.
  double scanned(double spin)
  {
    DrivingTorque near = samples.front();
    for (double here = scan_step * search.spin_scale; here < spin; here += scan_step * search.spin_scale)
    {
      const std::optional<DrivingTorque> found = sample_at(here);
      if (!found)
        return converge(near, here, {});
      if (found->torque <= 0.)
        return converge(
          near, (near.spin * found->torque - here * near.torque) / (found->torque - near.torque), found);
      near = *found;
    }
    return spin;
  }

  /// Returns the zero at @p spin if the balance holds from rest to @p spin, otherwise an earlier zero. Throws
  /// BalanceLost if the balance ends before any zero.
  double reached(double spin)
  {
    // A range of spins without balance is missed if it is narrower than the spacing of the sampled spins.
    constexpr unsigned int max_probes = 200;
    for (unsigned int i = 0; i < max_probes; ++i)
    {
      std::optional<double> probe = unsteadiest(spin);
      if (!probe)
        probe = middle_of_jump(spin);
      if (!probe)
        return spin;
      if (const std::optional<DrivingTorque> found = sample_at(*probe); !found || found->torque <= 0.)
        return converge(nearest_before(*probe), *probe, {});
    }
    return spin;
  }

  /// Returns the last sample before @p spin with a positive driving torque.
  DrivingTorque nearest_before(double spin) const
  {
    DrivingTorque near = samples.front();
    for (const DrivingTorque &sample : samples)
      if (sample.spin < spin && sample.spin > near.spin && sample.torque > 0.)
        near = sample;
    return near;
  }

  /// Returns the spin in [0, @p spin] at which the balance is most likely to end; std::nullopt if every
  /// interval between samples is narrow enough. The square of the stability margin is nearly convex in
  /// the spin (linear near a fold), so the lines through neighbouring samples bound it from below. Their
  /// slopes are multiplied by `safety`, because the square is not exactly convex.
  std::optional<double> unsteadiest(double spin) const
  {
    constexpr double safety = 1.5;
    const double narrowest = margin_distance_on_the_way * search.spin_scale;
    std::map<double, double> squares; // by spin; samples too close for a slope are omitted
    for (const DrivingTorque &sample : samples)
    {
      const auto next = squares.lower_bound(sample.spin - narrowest);
      if (sample.spin <= (1. + SpinSearch::rounding_distance) * spin &&
          (next == squares.end() || next->first > sample.spin + narrowest))
        squares[sample.spin] = std::pow(search.stability_margin(direction * sample.spin), 2);
    }
    const auto slope = [](auto one, auto other)
    { return (other->second - one->second) / (other->first - one->first); };
    std::map<double, double> wide;
    std::optional<double> worst;
    double least = 0.;
    for (auto right = std::next(squares.begin()); right != squares.end(); ++right)
    {
      const auto left = std::prev(right);
      const double width = right->first - left->first;
      const bool is_first = left == squares.begin(), is_last = std::next(right) == squares.end();
      const double lower = std::min(left->second, right->second);
      if (lower > SpinSearch::unsteady * SpinSearch::unsteady || width <= 2.5 * narrowest)
        continue;
      if (width > scan_step * search.spin_scale)
        return (left->first + right->first) / 2.;
      // If contact edges cross quadrature lines, a balance with a small stability margin can have small
      // folds. Intervals with a small margin must therefore be narrower.
      if (width > search.spin_scale * std::clamp(lower / 8., 1. / 256., scan_step))
        wide.emplace(lower, (left->first + right->first) / 2.);
      // Maximum rates at which the squared margin may decrease from either end into the interval.
      const double own = slope(left, right);
      const double from_left = safety * std::max(is_first ? 0. : -slope(std::prev(left), left), -own),
                   from_right = safety * std::max(is_last ? 0. : slope(right, std::next(right)), own);
      if (!(from_left > 0. && from_right > 0.))
        continue;
      const double share = std::clamp(
        (left->second - right->second + from_right * width) / ((from_left + from_right) * width), 0., 1.);
      const double bound = left->second - from_left * share * width;
      if (bound < least)
      {
        least = bound;
        // A sample closer to an end of the interval would coincide with the sample at this end.
        const double margin = std::max(0.1 * width, 1.1 * narrowest);
        worst = left->first + std::clamp(share * width, margin, width - margin);
      }
    }
    return !worst && !wide.empty() ? wide.begin()->second : worst;
  }

  /// Returns the middle of the interval before @p spin with the largest change of the torque at a small
  /// stability margin; std::nullopt if all changes are small. A large change in the narrowest interval is a
  /// jump to another balance: the glass tips there, and BalanceLost is thrown.
  std::optional<double> middle_of_jump(double spin) const
  {
    constexpr double unsteady_at_jump = 0.3; // stability margin next to the end of a balance
    const double narrowest = search.spin_scale / 131072.;
    double largest = 0.005 * samples.front().torque; // smaller changes are no jump
    std::map<double, double> torques;                // by spin
    for (const DrivingTorque &sample : samples)
      if (sample.spin <= spin)
        torques[sample.spin] = sample.torque;
    const auto is_unsteady = [&](double at)
    { return search.stability_margin(direction * at) < unsteady_at_jump; };
    std::optional<std::pair<double, double>> widest;
    for (auto right = std::next(torques.begin()); right != torques.end(); ++right)
      if (const auto left = std::prev(right); std::abs(right->second - left->second) > largest &&
                                              (is_unsteady(left->first) || is_unsteady(right->first)))
      {
        largest = std::abs(right->second - left->second);
        widest = { left->first, right->first };
      }
    if (!widest)
      return std::nullopt;
    const auto [left, right] = *widest;
    if (right - left <= narrowest)
      throw BalanceLost(sentence("the balance is lost at ", direction * left,
                                 " rad/s, before a terminal spin is reached: beyond, another balance has "
                                 "another tilt"),
                        direction * left, true);
    return (left + right) / 2.;
  }

  const std::function<double(double)> &driving_torque;
  const double direction;
  const SpinSearch &search;
  std::vector<DrivingTorque> samples;
};
} // namespace

TerminalSpin find_terminal_spin(const TorqueFunction &torque, const SpinSearch &search)
{
  require_positive(search.spin_scale, "the spin scale v / R", "rad/s");
  require_positive(search.tolerance, "the tolerance of the terminal spin", "");
  require(std::isfinite(search.grip_torque) && search.grip_torque >= 0., "the grip torque is ",
          search.grip_torque, " N m, but must be finite and not negative");
  const auto finite_torque = [&](double omega)
  {
    const double value = torque(omega);
    if (!std::isfinite(value))
      throw NoBalance(sentence("the yaw torque at ", omega, " rad/s is ", value, " N m"));
    return value;
  };

  const double at_rest = finite_torque(0.);
  if (std::abs(at_rest) <= std::max(search.grip_torque, search.torque_noise))
    return { 0., NAN, NAN, true, search.grip_torque > 0. };
  const double direction = at_rest > 0. ? 1. : -1.;
  const std::function<double(double)> driving_torque = [&](double spin)
  { return direction * finite_torque(direction * spin) - search.grip_torque; };
  const double expected = direction * search.initial_guess.value_or(0.);
  const double first = expected > 0. ? expected : first_step * search.spin_scale;
  OutwardSearch outward(driving_torque, std::abs(at_rest) - search.grip_torque, direction, search);
  return { direction * outward.zero(first) };
}
} // namespace stemware::ring
