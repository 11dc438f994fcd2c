#pragma once

#include "fem/contact/foot.h"
#include "fem/pipeline/coupling/load_report.h"
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

/// Load of a study as a function of the spin, with its contact.
class BalancedLoad : public ring::LoadAtSpin
{
public:
  /// Returns the full load at rest.
  virtual const LoadReport &report() const = 0;
  /// Returns the contact at the spin @p omega; std::nullopt for a load without a contact.
  virtual std::optional<fem::ContactState> contact(double /*omega*/) const { return std::nullopt; }
  /// Returns the statistics of the solved loads; std::nullopt if the load does not depend on the spin.
  virtual std::optional<CouplingStatistics> statistics() const { return std::nullopt; }

  double radius() const override { return report().rings.radius(); }
  bool is_pressure() const override { return contact(0).has_value(); }
};

/// Shared load: balances solved for one owner are cached for all owners.
using SharedLoad = std::shared_ptr<const BalancedLoad>;

/// Load given by a function of the spin, or constant, truncated to n_harmonics.
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
  /// Constant load of the contact @p state.
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

/// Returns the report of a load given by a formula; pointwise quantities are evaluated from the series.
LoadReport report_of(const ring::RingStack &load);

/// Returns the report on the load of a contact state, with the tilt if @p tilts.
LoadReport report_of(const fem::ContactState &state, double contact_radius, bool tilts);

} // namespace stemware::pipeline
