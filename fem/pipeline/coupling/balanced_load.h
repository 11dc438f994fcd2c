#pragma once

#include "fem/contact/foot.h"
#include "fem/pipeline/coupling/balanced_contact.h"
#include "fem/pipeline/coupling/load_report.h"
#include "ring_model/spin/load.h"

#include <cstddef>
#include <deque>
#include <memory>
#include <optional>
#include <utility>

namespace stemware::pipeline
{

/// Contacts of an elastic foot by the spin: in balance at every spin, or the contact at rest at all.
class ContactsBySpin
{
public:
  /// @p at_rest: the contact at rest, whose marks all contacts have. @p progress must outlive the contacts.
  ContactsBySpin(const std::shared_ptr<ElasticFoot> &foot, const ContactBalance &balance,
                 const fem::ContactState &at_rest, Progress &progress);

  /// Returns the contact at the spin @p omega; the latest sample()s have theirs at hand. Throws ring::Tipping
  /// and ring::NoBalance.
  fem::ContactState contact(double omega);
  /// Returns the load of the contact at the spin @p omega. Throws as contact().
  ring::Sample sample(double omega);
  /// Returns the statistics; std::nullopt if the contact does not depend on the spin.
  std::optional<CouplingStatistics> statistics() const;

private:
  BalancedContact contacts;
  const bool varies_with_spin;
  const fem::ContactState at_rest;
  Progress &progress;
  std::size_t n_balances = 0;
  std::deque<std::pair<double, fem::ContactState>> latest; ///< newest first
};

/// Load of a study as a function of the spin, with its contact beside it.
class BalancedLoad : public ring::Load
{
public:
  /// @p at_rest: report on the whole load, not truncated. @p contacts: nullptr for a load without a contact.
  BalancedLoad(const ring::Load &load, LoadReport at_rest, std::shared_ptr<ContactsBySpin> contacts = nullptr)
      : ring::Load(load)
      , at_rest(std::move(at_rest))
      , contacts(std::move(contacts))
  {
  }

  /// Returns the full load at rest.
  const LoadReport &report() const { return at_rest; }
  /// Returns the contact at the spin @p omega; std::nullopt for a load without a contact. Throws NoBalance.
  std::optional<fem::ContactState> contact(double omega) const
  {
    return contacts ? std::optional(contacts->contact(omega)) : std::nullopt;
  }
  /// Returns the statistics of the solved loads; std::nullopt if the load does not depend on the spin.
  std::optional<CouplingStatistics> statistics() const
  {
    return contacts ? contacts->statistics() : std::nullopt;
  }

  /// Returns @p load with the report and the contacts of this one.
  BalancedLoad with(const ring::Load &load) const { return { load, at_rest, contacts }; }

private:
  LoadReport at_rest;
  std::shared_ptr<ContactsBySpin> contacts;
};

/// Returns the constant load @p load, given by a formula, truncated to @p n_harmonics.
BalancedLoad given_load(const ring::RingStack &load, unsigned int n_harmonics = all_harmonics);

/// Returns the report of a load given by a formula; pointwise quantities are evaluated from the series.
LoadReport report_of(const ring::RingStack &load);

/// Returns the report on the load of a contact state, with the tilt if @p tilts.
LoadReport report_of(const fem::ContactState &state, double contact_radius, bool tilts);

} // namespace stemware::pipeline
