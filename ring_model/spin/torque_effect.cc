#include "ring_model/spin/torque_effect.h"

#include "ring_model/failures.h"
#include "ring_model/friction_functionals.h"

#include <boost/math/tools/minima.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace stemware::ring
{
namespace
{
using Torque = std::optional<TorqueByHarmonics>;

std::optional<TorqueEffect::AtSpin> effect_at(const Torque &torque, unsigned int n)
{
  if (!torque)
    return std::nullopt;
  return TorqueEffect::AtSpin{ torque->change(n), torque->rest(n), torque->bound(n) };
}

/// Returns the spin at which |change| is largest. @p i: index of the sample in @p spins with the largest
/// |change|.
template <typename Change>
double polished_maximum(const std::vector<double> &spins, std::size_t i, const Change &change)
{
  constexpr int n_bits = 20; // of the spin; the error of the maximum is quadratic in the error of the spin
  const auto [low, high] = std::minmax(spins[i > 0 ? i - 1 : 0], spins[std::min(i + 1, spins.size() - 1)]);
  const auto found = boost::math::tools::brent_find_minima(
    [&](double omega) { return -std::abs(change(omega)); }, low, high, n_bits);
  return -found.second > std::abs(change(spins[i])) ? found.first : spins[i];
}

template <typename TorqueAt>
void add_curve(const std::vector<double> &spins, const std::vector<Torque> &torques,
               const TorqueAt &torque_at, TorqueEffect &row)
{
  const auto change_of = [&](const Torque &torque)
  { return torque ? torque->change(row.harmonics) : std::numeric_limits<double>::quiet_NaN(); };
  std::size_t largest = 0;
  for (std::size_t i = 0; i < spins.size(); ++i)
  {
    row.curve.push_back(change_of(torques[i]));
    if (std::abs(row.curve[i]) > std::abs(row.curve[largest]))
      largest = i;
  }
  const auto change = [&](double omega)
  {
    const double value = change_of(torque_at(omega));
    return std::isfinite(value) ? value : 0.;
  };
  row.largest_at = row.curve[largest] == 0. ? 0. : polished_maximum(spins, largest, change);
  row.largest = change(*row.largest_at);
}
} // namespace

TorqueEffects torque_effects(const Load &load, const Motion &motion, const Answer &all,
                             const std::vector<unsigned int> &orders, const Load *curve)
{
  constexpr unsigned int n_intervals = 64;
  const auto torque_of = [&motion](const Load &of, double omega) -> Torque
  { return find_or_nullopt([&] { return TorqueByHarmonics(motion, of.at(omega), omega); }); };
  TorqueEffects effects = { std::abs(all.at_rest.value().friction.torque) };
  Torque half, terminal;
  if (all.terminal)
  {
    half = torque_of(load, all.terminal->omega / 2);
    terminal = TorqueByHarmonics(motion, all.at_terminal.value().load, all.terminal->omega);
  }
  std::vector<Torque> torques;
  const double last = all.last_spin().value_or(0.);
  for (unsigned int i = 0; curve && i <= n_intervals; ++i)
  {
    effects.spins.push_back(last * i / n_intervals + 0.); // + 0. avoids -0
    torques.push_back(torque_of(*curve, effects.spins.back()));
  }
  for (const unsigned int n : orders)
  {
    TorqueEffect &row = effects.rows.emplace_back();
    row.harmonics = n;
    row.half = effect_at(half, n);
    row.terminal = effect_at(terminal, n);
    if (curve)
      add_curve(
        effects.spins, torques, [&](double omega) { return torque_of(*curve, omega); }, row);
  }
  return effects;
}
} // namespace stemware::ring
