#include "fem/pipeline/analysis/changed_load.h"

#include "ring_model/if_balanced.h"
#include "ring_model/no_balance.h"

#include <algorithm>

namespace stemware::pipeline
{

namespace
{

Eigen::VectorXd difference(const BalancedLoad &own, const BalancedLoad &changed, double omega,
                           unsigned int n_harmonics)
{
  return changed.at(omega, {}).coefficients(n_harmonics) - own.at(omega, {}).coefficients(n_harmonics);
}

} // namespace

LoadChange change_at_rest(const BalancedLoad &own, const BalancedLoad &changed)
{
  LoadChange change = { std::max(own.n_harmonics(), changed.n_harmonics()) };
  change.at_rest = difference(own, changed, 0, change.n_harmonics);
  change.per_spin = Eigen::VectorXd::Zero(change.at_rest.size());
  return change;
}

Eigen::VectorXd change_per_spin(const BalancedLoad &own, const BalancedLoad &changed,
                                const LoadChange &at_rest, double omega)
{
  if (omega == 0)
    return at_rest.per_spin;
  const auto find = [&]() -> Eigen::VectorXd
  { return (difference(own, changed, omega, at_rest.n_harmonics) - at_rest.at_rest) / omega; };
  return ring::if_balanced(find).value_or(Eigen::VectorXd());
}

BalancedLoad changed_load(const BalancedLoad &own, const BalancedLoad &changed, const LoadChange &change)
{
  return changed.with(ring::Load(
    [own, change, n_harmonics = own.n_harmonics()](double omega)
    {
      const ring::Sample before = own.at(omega);
      if (omega != 0 && change.per_spin.size() == 0)
        throw ring::NoBalance("the changed foot has no balance at the terminal spin");
      Eigen::VectorXd row = before.coefficients(change.n_harmonics) + change.at_rest;
      if (omega != 0)
        row += omega * change.per_spin;
      return ring::Sample::from_coefficients(row, before.rings().size()).truncated(n_harmonics);
    },
    true));
}

} // namespace stemware::pipeline
