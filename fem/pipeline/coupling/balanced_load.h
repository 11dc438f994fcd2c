#pragma once

#include "fem/contact/foot.h"
#include "fem/pipeline/coupling/contact_report.h"
#include "ring_model/load_model.h"
#include "ring_model/moment_balance.h"
#include "ring_model/motion.h"
#include "ring_model/spin/load_at_spin.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

namespace stemware::pipeline
{

/// No truncation.
inline constexpr unsigned int all_harmonics = std::numeric_limits<unsigned int>::max();

/// Load of a study at every spin, with the contact behind it.
class BalancedLoad : public ring::LoadAtSpin
{
public:
  /// The whole load at rest.
  virtual const LoadReport &report() const = 0;
  /// Contact at the spin @p omega; std::nullopt if the load does not come from one.
  virtual std::optional<fem::ContactState> contact(double /*omega*/) const { return std::nullopt; }
  /// Returns the statistics of the solved loads; std::nullopt if the load does not depend on the spin.
  virtual std::optional<CouplingStatistics> statistics() const { return std::nullopt; }

  double radius() const override { return report().rings.radius(); }
  bool is_pressure() const override { return contact(0).has_value(); }
};

/// Loads are shared: the balances that one owner finds are known to all.
using SharedLoad = std::shared_ptr<const BalancedLoad>;

/// The first @p n_harmonics of a load that a function of the spin gives, or that is the same at every spin.
class GivenLoad : public BalancedLoad
{
public:
  explicit GivenLoad(LoadReport at_rest, unsigned int n_harmonics = all_harmonics,
                     std::function<ring::LeaningLoad(double omega)> function = {})
      : at_rest(std::move(at_rest))
      , n_kept(std::min(n_harmonics, this->at_rest.rings.n_harmonics()))
      , function(std::move(function))
  {
  }
  /// The same at every spin, from the contact @p state.
  GivenLoad(LoadReport at_rest, unsigned int n_harmonics, const fem::ContactState &state)
      : GivenLoad(std::move(at_rest), n_harmonics)
  {
    this->state = state;
  }

  ring::LeaningLoad at(double omega, const std::optional<ring::Orientation> &) const override
  {
    return (function ? function(omega) : ring::LeaningLoad(at_rest.rings, at_rest.tilt)).truncated(n_kept);
  }
  unsigned int n_harmonics() const override { return n_kept; }
  const LoadReport &report() const override { return at_rest; }
  std::optional<fem::ContactState> contact(double) const override { return state; }

private:
  const LoadReport at_rest;
  const unsigned int n_kept;
  const std::function<ring::LeaningLoad(double omega)> function;
  std::optional<fem::ContactState> state;
};

/// The load of @p model in balance with the friction of its own first @p n_harmonics at every spin; @p
/// at_rest is the load at omega = 0, where the friction, (-mu N, 0), is known beforehand. @p n_harmonics cuts
/// what enters T and tau_z; friction in an elastic foot feels the whole pressure.
///
/// The load throws as ring::SelfConsistentRing::at() and the model do.
SharedLoad balance(const std::shared_ptr<const ring::LoadModel> &model, const ring::Motion &motion,
                   ring::Closure closure, LoadReport at_rest, unsigned int n_harmonics = all_harmonics);

/// A load that a formula gives, as a report: pointwise quantities are those of the series.
LoadReport report_of(const ring::RingStack &load);

} // namespace stemware::pipeline
