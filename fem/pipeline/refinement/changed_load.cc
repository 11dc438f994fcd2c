#include "fem/pipeline/refinement/changed_load.h"

#include "ring_model/if_balanced.h"
#include "ring_model/no_balance.h"

#include <algorithm>
#include <utility>

namespace stemware::pipeline
{

namespace
{

class ChangedLoad : public BalancedLoad
{
public:
  ChangedLoad(SharedLoad own, SharedLoad changed, LoadChange change)
      : own(std::move(own))
      , changed(std::move(changed))
      , change(std::move(change))
  {
  }

  ring::LeaningLoad at(double omega, const std::optional<ring::Orientation> &marks) const override
  {
    const ring::LeaningLoad load = own->at(omega, marks);
    Eigen::VectorXd row = load.coefficients(change.n_harmonics) + change.at_rest;
    if (omega != 0 && change.per_spin.size() == 0)
      throw ring::NoBalance("the changed foot has no balance at the terminal spin");
    if (omega != 0)
      row += omega * change.per_spin;
    return ring::LeaningLoad::from_coefficients(row, load.rings().size()).truncated(n_harmonics());
  }
  unsigned int n_harmonics() const override { return own->n_harmonics(); }
  const LoadReport &report() const override { return changed->report(); }
  std::optional<fem::ContactState> contact(double omega) const override { return changed->contact(omega); }

private:
  const SharedLoad own, changed;
  const LoadChange change;
};

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

SharedLoad changed_load(SharedLoad own, SharedLoad changed, LoadChange change)
{
  return std::make_shared<ChangedLoad>(std::move(own), std::move(changed), std::move(change));
}

} // namespace stemware::pipeline
