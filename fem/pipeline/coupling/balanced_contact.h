#pragma once

#include "fem/pipeline/base/progress.h"
#include "fem/pipeline/coupling/elastic_foot.h"
#include "ring_model/moment_balance.h"
#include "ring_model/motion.h"
#include "ring_model/spin/sample.h"

#include <cstddef>
#include <deque>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

namespace stemware::pipeline
{

/// Number of harmonics of a load without truncation.
inline constexpr unsigned int all_harmonics = std::numeric_limits<unsigned int>::max();

/// Statistics of a load that is in balance with friction at every spin.
struct CouplingStatistics
{
  std::size_t n_balances = 0;          ///< spins with a balance of contact, friction and moments
  std::size_t n_contact_solutions = 0; ///< contact solves for these balances
};

/// Moment balance of an elastic foot.
struct ContactBalance
{
  ring::Motion motion;
  ring::Closure closure = ring::Closure::full;
  ring::Orientation orientation; ///< azimuths of the marks of glass and table
  bool tilts = false;            ///< true if the weight of the tilted glass enters the balance
  bool varies_with_spin = false; ///< true if every spin has its own contact
  /// Number of the rings' harmonics whose friction enters the moment balance.
  unsigned int n_harmonics = all_harmonics;
};

/// Elastic foot at a sequence of spins, each solved from the previous one, with contact, friction and moment
/// balance as one system (fem::ContactDemand).
class BalancedContact
{
public:
  /// @p start: initial guess for the first requested contact; std::nullopt: the last contact of @p foot.
  BalancedContact(std::shared_ptr<ElasticFoot> foot, const ContactBalance &balance,
                  std::optional<fem::ContactState> start = {});
  /// @p at_rest: contact at rest, returned for all spins unless ContactBalance::varies_with_spin.
  /// @p progress, which receives the spins in balance, must outlive the object.
  BalancedContact(std::shared_ptr<ElasticFoot> foot, const ContactBalance &balance,
                  const fem::ContactState &at_rest, Progress &progress);

  /// Returns the contact at the spin @p omega [rad/s], cached. Throws ring::Tipping and ring::NoBalance.
  fem::ContactState contact(double omega);
  /// Returns the load of a contact(), up to ContactBalance::n_harmonics, with margins and tilt (if included).
  ring::Sample sample_of(const fem::ContactState &state) const;
  /// Returns sample_of() contact() at the spin @p omega [rad/s].
  ring::Sample sample(double omega);

  /// Returns the statistics; std::nullopt if the contact does not depend on the spin.
  std::optional<CouplingStatistics> statistics() const;

private:
  fem::ContactDemand demand_at(double omega, const std::vector<double> &radii, double rotation) const;
  /// Starts from the previous contact, even if the foot has been solved again since.
  fem::ContactState solve(const fem::ContactDemand &demand, double omega);
  /// Solves with the friction force of the single ring that has the contact's moment and first harmonic.
  fem::ContactState contact_on_one_ring(double omega);

  const std::shared_ptr<ElasticFoot> foot;
  const ContactBalance balance;
  double one_radius;       ///< radius of the single ring, last solution [m]
  double one_rotation = 0; ///< [rad]
  CouplingStatistics counts;
  std::optional<fem::ContactState> before, at_rest;
  Progress &progress = silent_progress();
  std::deque<std::pair<double, fem::ContactState>> latest; ///< cached solutions by spin, newest first
};

} // namespace stemware::pipeline
