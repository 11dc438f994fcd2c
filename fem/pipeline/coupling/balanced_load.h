#pragma once

#include "fem/contact/contact_load.h"
#include "fem/contact/foot.h"
#include "fem/pipeline/coupling/balanced_contact.h"
#include "ring_model/spin/load.h"

#include <Eigen/Core>

#include <memory>
#include <optional>
#include <utility>

namespace stemware::pipeline
{

/// Load on the rings, with resultants and extent of the contact. Without a contact, `contact_fraction` is the
/// share of the azimuths with a positive load, `peak_pressure` is 0, and `pointwise` is empty.
struct LoadReport : fem::ContactLoad
{
  double moment_ratio = 0;                        ///< |M_N| / (N R / 2), R the contact radius
  Eigen::Vector2d tilt = Eigen::Vector2d::Zero(); ///< Sample::tilt [rad]
  double inner_radius = 0;                        ///< radii that enclose the load [m]
  double outer_radius = 0;
  /// Largest width of the contact across the rim, fem::contact_width() [m]; empty if the mesh is too coarse.
  std::optional<double> contact_width = {};
  /// Minimum of contact_fraction over the sampled phases; empty for a load independent of the phase.
  std::optional<double> least_contact_fraction = {};

  /// Returns the half-width of the loaded range of radii [m].
  double half_width() const { return (outer_radius - inner_radius) / 2; }
};

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
