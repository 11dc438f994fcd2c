#pragma once

#include "fem/contact/foot.h"
#include "fem/pipeline/coupling/balanced_contact.h"
#include "fem/pipeline/coupling/load_report.h"
#include "ring_model/spin/load.h"

#include <memory>
#include <optional>
#include <utility>

namespace stemware::pipeline
{

/// Load of a study as a function of the spin, with its contacts.
class BalancedLoad : public ring::Load
{
public:
  /// @p at_rest: report on the untruncated load. @p contacts: nullptr for a load without a contact.
  BalancedLoad(const ring::Load &load, LoadReport at_rest,
               std::shared_ptr<BalancedContact> contacts = nullptr)
      : ring::Load(load)
      , at_rest(std::move(at_rest))
      , contacts(std::move(contacts))
  {
  }

  /// Returns the report on the untruncated load at rest.
  const LoadReport &report() const { return at_rest; }
  /// Returns the contact at the spin @p omega [rad/s]; std::nullopt without a contact. Throws NoBalance.
  std::optional<fem::ContactState> contact(double omega) const
  {
    return contacts ? std::optional(contacts->contact(omega)) : std::nullopt;
  }
  /// Returns the statistics of the balances; std::nullopt if the load does not depend on the spin.
  std::optional<CouplingStatistics> statistics() const
  {
    return contacts ? contacts->statistics() : std::nullopt;
  }

  /// Returns @p load with the report and the contacts of this load.
  BalancedLoad with(const ring::Load &load) const { return { load, at_rest, contacts }; }

private:
  LoadReport at_rest;
  std::shared_ptr<BalancedContact> contacts;
};

/// Returns the load @p load at every spin.
BalancedLoad given_load(const ring::RingStack &load);

/// Returns the report on a load without a contact; minimum and loaded azimuths come from its Fourier series.
LoadReport report_of(const ring::RingStack &load);

/// Returns the report on the load of a contact state, with the tilt if @p tilts.
LoadReport report_of(const fem::ContactState &state, double contact_radius, bool tilts);

} // namespace stemware::pipeline
