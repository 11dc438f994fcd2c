#include "fem/pipeline/coupling/balanced_states.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace stemware::pipeline
{

BalancedStates::BalancedStates(ring::SelfConsistentRing glass, double spin_scale,
                               const ring::Orientation &orientation)
    : glass(std::move(glass))
    , reach(spin_scale / 4)
    , orientation(orientation)
{
}

const ring::RingEquilibrium &BalancedStates::at(double omega)
{
  const auto known = states.find(omega);
  if (known != states.end())
    return known->second.balance;
  const ring::BalanceStart start = start_near(omega);
  const ring::RingEquilibrium balance = glass.at(omega, &start, orientation);
  const Eigen::Vector2d correction = balance.balance.moment - glass.first_harmonic_start(omega).moment;
  return states.emplace(omega, State{ balance, correction }).first->second.balance;
}

std::vector<BalancedStates::States::const_iterator> BalancedStates::neighbours(double omega) const
{
  constexpr std::size_t most = 6;
  std::vector<States::const_iterator> chosen;
  auto above = states.lower_bound(omega);
  auto below = std::make_reverse_iterator(above);
  while (chosen.size() < most && (above != states.end() || below != states.rend()))
  {
    const bool take_above =
      below == states.rend() || (above != states.end() && above->first - omega <= omega - below->first);
    const States::const_iterator next =
      take_above ? States::const_iterator(above++) : std::prev((below++).base());
    const double distance = std::abs(next->first - omega);
    if (distance > reach)
      break;
    // Points that are close together compared with their distance from here would amplify errors.
    const auto too_close = [&](const auto &other)
    { return std::abs(next->first - other->first) < 0.5 * distance; };
    if (std::none_of(chosen.begin(), chosen.end(), too_close))
      chosen.push_back(next);
  }
  return chosen;
}

ring::BalanceStart BalancedStates::start_near(double omega) const
{
  ring::BalanceStart start = glass.first_harmonic_start(omega);
  const auto known = neighbours(omega);
  if (known.empty())
    return start;
  for (const auto &state : known)
  {
    double weight = 1; // Lagrange's polynomial through all of them
    for (const auto &other : known)
      if (other != state)
        weight *= (omega - other->first) / (state->first - other->first);
    start.moment += weight * state->second.correction;
  }
  start.jacobian = known.front()->second.balance.balance.jacobian;
  return start;
}

} // namespace stemware::pipeline
