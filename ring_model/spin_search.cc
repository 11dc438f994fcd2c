#include "ring_model/spin_search.h"

#include "ring_model/if_balanced.h"
#include "ring_model/load/lagrange.h"
#include "ring_model/load/require.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <iterator>
#include <map>
#include <vector>

namespace stemware::ring
{
namespace
{
constexpr double farthest = 64.;              ///< end of the search [spin scales]
constexpr double shortest_way = 1. / 4096.;   ///< to a spin without torque, before one gives up [spin scales]
constexpr double scan_step = 1. / 16.;        ///< [spin scales]
constexpr double steepness_ratio = 16.;       ///< of the torque near the zero to the mean that needs no scan
constexpr unsigned int max_evaluations = 200; ///< of one search
constexpr double unsteady = 0.9;              ///< stability margin below which the balance may end nearby

/// Push on the glass at a spin, both counted in the direction in which the glass is driven at rest.
struct Sample
{
  double spin; ///< > 0 [rad/s]
  double push; ///< tau_z - tau_g [N m], positive before the zero
};

/// Estimate of the spin at which the push vanishes.
struct Estimate
{
  double spin;  ///< by the polynomial spin(push) through at most four samples
  double error; ///< its difference to the one without the sample farthest away
};

/// Estimate by the samples with the least |push|; as many as fall with the spin.
Estimate inverse_interpolation(std::vector<Sample> samples)
{
  std::sort(samples.begin(), samples.end(),
            [](const Sample &a, const Sample &b) { return std::abs(a.push) < std::abs(b.push); });
  const auto falls = [&](std::size_t n)
  {
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (!((samples[i].push - samples[j].push) * (samples[i].spin - samples[j].spin) < 0.))
          return false;
    return true;
  };
  std::size_t n = std::min<std::size_t>(samples.size(), 4);
  while (!falls(n))
    --n;
  const auto through = [&](std::size_t n_used)
  {
    Eigen::VectorXd pushes(n_used), ways(n_used); // from the spin of the least push, for the digits
    for (std::size_t i = 0; i < n_used; ++i)
    {
      pushes(i) = samples[i].push;
      ways(i) = samples[i].spin - samples.front().spin;
    }
    return samples.front().spin + lagrange_values(pushes, 0.).dot(ways);
  };
  return n < 2 ? Estimate{ through(1), HUGE_VAL }
               : Estimate{ through(n), std::abs(through(n) - through(n - 1)) };
}

/// @p failure, met just beyond the spin @p last, as what it means for the spin-up.
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

/// The search from rest in the direction in which the glass is driven there.
class OutwardSearch
{
public:
  /// @p push_at_rest > 0 is @p push(0); @p direction is the sign of the spin.
  OutwardSearch(const std::function<double(double)> &push, double push_at_rest, double direction,
                const SpinSearch &search)
      : push(push)
      , direction(direction)
      , search(search)
      , samples{ { 0., push_at_rest } }
  {
  }

  /// The first zero; the spin @p first > 0 is tried first.
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
  /// The zero beyond @p near, where the push is positive, and before @p far, where it is negative.
  double converge(Sample near, double proposal, std::optional<Sample> far)
  {
    std::vector<Sample> used{ near };
    if (far)
      used.push_back(*far);
    std::exception_ptr failure; // of the torque at `barrier`
    double barrier = 0.;
    double width = HUGE_VAL; // of what lay between `near` and there
    bool may_extrapolate = true;
    for (unsigned int i = 0; i < max_evaluations; ++i)
    {
      const double least = std::abs(std::min_element(used.begin(), used.end(),
                                                     [](const Sample &a, const Sample &b)
                                                     { return std::abs(a.push) < std::abs(b.push); })
                                      ->push);
      Sample sample{ proposal, 0. };
      bool has_push = true, halved = true;
      try
      {
        sample.push = push(proposal);
      }
      catch (const NoBalance &)
      {
        failure = std::current_exception();
        barrier = proposal;
        far.reset();
        has_push = false;
        used.erase(std::remove_if(used.begin(), used.end(),
                                  [&](const Sample &other) { return other.spin > proposal; }),
                   used.end());
      }
      if (has_push)
      {
        used.push_back(sample);
        samples.push_back(sample);
        if (sample.push == 0.)
          return sample.spin;
        halved = used.size() <= 2 || std::abs(sample.push) <= 0.5 * least;
        if (sample.push > 0.)
          near = sample;
        else
        {
          far = sample;
          failure = nullptr;
        }
      }
      const Estimate estimate = inverse_interpolation(used);
      const double tolerance = search.tolerance * std::max(estimate.spin, 1e-3 * search.spin_scale);
      if (estimate.error <= tolerance && !(failure && estimate.spin >= barrier))
        return estimate.spin;
      if (far && far->spin - near.spin <= tolerance)
        return (near.spin + far->spin) / 2.;
      if (failure && barrier - near.spin < shortest_way * search.spin_scale)
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

  /// The next proposal between @p near and @p end, or not much farther than @p near without end.
  double next(const Estimate &estimate, double near, const double *end, bool halved) const
  {
    const double reach = end ? *end : near + 2. * std::max(near, 0.25 * search.spin_scale);
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

  /// A place next to where the balance that there is at @p near should end before @p barrier, as its
  /// stability margin foretells; nothing where that tells nothing.
  std::optional<double> next_to_the_end(double near, double barrier) const
  {
    if (!search.stability_margin)
      return std::nullopt;
    const double narrowest = search.spin_scale / 1024.;
    double before = -1.;
    for (const Sample &sample : samples)
      if (sample.spin < near - narrowest && sample.spin > before)
        before = sample.spin;
    if (before < 0.)
      return std::nullopt;
    const auto square = [&](double spin) { return std::pow(search.stability_margin(direction * spin), 2); };
    const double left = square(before), right = square(near);
    if (!(right < left))
      return std::nullopt;
    const double end = near + right * (near - before) / (left - right);
    const double width = barrier - near, enough = shortest_way * search.spin_scale;
    if (end - near < 0.5 * enough)
      return near + std::min(0.9 * enough, 0.5 * width);
    return std::clamp(end - 0.3 * enough, near + 0.05 * width, barrier - 0.05 * width);
  }

  /// Whether the samples up to the zero at @p spin leave doubt that it is the first. Takes one about
  /// halfway if there is none.
  bool needs_scan(double spin)
  {
    std::vector<Sample> way;
    std::copy_if(samples.begin(), samples.end(), std::back_inserter(way),
                 [&](const Sample &sample) { return sample.spin < spin; });
    if (std::none_of(way.begin(), way.end(),
                     [&](const Sample &sample)
                     { return sample.spin > 0.2 * spin && sample.spin < 0.8 * spin; }))
    {
      const std::optional<double> halfway = push_if_balanced(0.5 * spin);
      if (!halfway)
        return true;
      way.push_back({ 0.5 * spin, *halfway });
    }
    std::sort(way.begin(), way.end(), [](const Sample &a, const Sample &b) { return a.spin < b.spin; });
    for (std::size_t i = 1; i < way.size(); ++i)
      if (way[i].push >= way[i - 1].push)
        return true;
    // Next to the zero itself rounding decides about the slope.
    const double too_close = 1e-6 * search.spin_scale;
    const Sample *nearest = nullptr;
    for (const Sample &sample : samples)
      if (std::abs(sample.spin - spin) > too_close &&
          (!nearest || std::abs(sample.spin - spin) < std::abs(nearest->spin - spin)))
        nearest = &sample;
    if (!nearest)
      return false;
    const double mean = samples.front().push / spin;
    const double local = nearest->push / (spin - nearest->spin);
    return !(local * steepness_ratio > mean && local < steepness_ratio * mean);
  }

  std::optional<double> push_if_balanced(double spin)
  {
    return if_balanced([&] { return samples.emplace_back(Sample{ spin, push(spin) }).push; });
  }

  /// The first zero before the one at @p spin, or that one. Throws BalanceLost where the way to it ends.
  double scanned(double spin)
  {
    Sample near = samples.front();
    for (double here = scan_step * search.spin_scale; here < spin; here += scan_step * search.spin_scale)
    {
      const std::optional<double> found = push_if_balanced(here);
      if (!found)
        return converge(near, here, {});
      const Sample sample{ here, *found };
      if (sample.push <= 0.)
        return converge(near, (near.spin * sample.push - sample.spin * near.push) / (sample.push - near.push),
                        sample);
      near = sample;
    }
    return spin;
  }

  /// The zero at @p spin, if the balance holds all the way to it, or the first one before it.
  double reached(double spin)
  {
    constexpr unsigned int max_probes = 100;
    for (unsigned int i = 0; i < max_probes; ++i)
    {
      const std::optional<double> probe = unsteadiest(spin);
      if (!probe)
        return spin;
      if (const std::optional<double> found = push_if_balanced(*probe); !found || *found <= 0.)
        return converge(nearest_before(*probe), *probe, {});
    }
    return spin;
  }

  /// The last sample before @p spin in which the push is positive.
  Sample nearest_before(double spin) const
  {
    Sample near = samples.front();
    for (const Sample &sample : samples)
      if (sample.spin < spin && sample.spin > near.spin && sample.push > 0.)
        near = sample;
    return near;
  }

  /// Where the balance on the way to @p spin may end; nothing where it is steady all the way, or known well
  /// enough not to. The square of the stability margin falls towards a fold nearly on a line, so that the
  /// lines through its neighbours bound it between two samples; with a factor, because it is not quite
  /// convex.
  std::optional<double> unsteadiest(double spin) const
  {
    constexpr double safety = 1.5;
    const double narrowest = search.spin_scale / 8192.;
    std::map<double, double> squares; // by spin; samples that are too close together tell no slope
    for (const Sample &sample : samples)
    {
      const auto next = squares.lower_bound(sample.spin - narrowest);
      if (sample.spin <= (1. + 1e-6) * spin &&
          (next == squares.end() || next->first > sample.spin + narrowest))
        squares[sample.spin] = std::pow(search.stability_margin(direction * sample.spin), 2);
    }
    const auto slope = [](auto one, auto other)
    { return (other->second - one->second) / (other->first - one->first); };
    std::map<double, double> wide; // middles of intervals by the lower square
    std::optional<double> worst;
    double least = 0.;
    for (auto right = std::next(squares.begin()); right != squares.end(); ++right)
    {
      const auto left = std::prev(right);
      const double width = right->first - left->first;
      const bool is_first = left == squares.begin(), is_last = std::next(right) == squares.end();
      const double lower = std::min(left->second, right->second);
      if (lower > unsteady * unsteady || width <= 2. * narrowest)
        continue;
      if (width > search.spin_scale / 16.)
        return (left->first + right->first) / 2.;
      // The less steady, the closer: edges that cross a line make a fold of their own.
      if (width > search.spin_scale * std::clamp(lower / 8., 1. / 256., 1. / 16.))
        wide.emplace(lower, (left->first + right->first) / 2.);
      // How fast the square falls into the interval from either side.
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
        worst = left->first + std::clamp(share, 0.1, 0.9) * width;
      }
    }
    return !worst && !wide.empty() ? wide.begin()->second : worst;
  }

  const std::function<double(double)> &push;
  const double direction;
  const SpinSearch &search;
  std::vector<Sample> samples; ///< the first one at spin 0
};
} // namespace

SpinZero find_terminal_spin(const TorqueFunction &torque, const SpinSearch &search)
{
  require_positive(search.spin_scale, "the spin scale v / R", "rad/s");
  require_positive(search.tolerance, "the tolerance of the terminal spin", "");
  require(std::isfinite(search.grip_torque) && search.grip_torque >= 0., "the grip torque is ",
          search.grip_torque, " N m, but must be finite and not negative");
  unsigned int n_evaluations = 0;
  const auto counted = [&](double omega)
  {
    ++n_evaluations;
    const double value = torque(omega);
    if (!std::isfinite(value))
      throw NoBalance(sentence("the yaw torque at ", omega, " rad/s is ", value, " N m"));
    return value;
  };

  const double at_rest = counted(0.);
  if (std::abs(at_rest) <= std::max(search.grip_torque, search.torque_noise))
    return { 0., search.grip_torque > 0., n_evaluations, 0. };
  const double direction = at_rest > 0. ? 1. : -1.;
  const std::function<double(double)> push = [&](double spin)
  { return direction * counted(direction * spin) - search.grip_torque; };
  const double expected = direction * search.initial_guess.value_or(0.);
  const double first = expected > 0. ? expected : 0.25 * search.spin_scale;
  OutwardSearch outward(push, std::abs(at_rest) - search.grip_torque, direction, search);
  const double spin = outward.zero(first);
  return { direction * spin, false, n_evaluations, direction * spin };
}

std::optional<SpinZero> find_terminal_spin_near(const ZeroGuess &known, const TorqueFunction &torque,
                                                const SpinSearch &search)
{
  constexpr unsigned int max_steps = 8;
  constexpr double nearly = 1e-7;    // of the spin: a load there is that at the zero
  constexpr double of_another = 0.1; // error of a slope that is another torque's, of itself
  const double grip = std::copysign(search.grip_torque, known.omega);
  const double scale = std::max(std::abs(known.omega), 1e-3 * search.spin_scale);
  double spin = known.omega, slope = known.slope, slope_error = of_another;
  double value = torque(spin) - grip;
  for (unsigned int n = 1; n <= max_steps; ++n)
  {
    const double step = -value / slope, next = spin + step;
    if (std::abs(step) <= nearly * scale && slope_error * std::abs(step) <= search.tolerance * scale)
    {
      if (search.stability_margin && search.stability_margin(spin) < unsteady)
        return std::nullopt;
      return SpinZero{ next, false, n, spin };
    }
    if (!(std::abs(next - known.omega) <= 0.1 * search.spin_scale))
      return std::nullopt;
    const double next_value = torque(next) - grip;
    const double secant = (next_value - value) / step;
    // Differences that rounding makes say nothing about the slope.
    if (std::abs(step) > 1e-6 * search.spin_scale)
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
} // namespace stemware::ring
