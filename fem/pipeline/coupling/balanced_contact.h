#pragma once

#include "fem/pipeline/coupling/balanced_load.h"
#include "fem/pipeline/coupling/elastic_foot.h"
#include "ring_model/moment_balance.h"
#include "ring_model/motion.h"

#include <cstddef>
#include <memory>
#include <optional>

namespace stemware::pipeline
{

/// Balance of moments that an elastic foot is to be in.
struct ContactBalance
{
  ring::Motion motion;
  ring::Closure closure = ring::Closure::full;
  ring::Orientation orientation; ///< of the marks of glass and table
  bool tilts = false;            ///< whether the weight of the leaning glass is part of it
  /// Harmonics of the rings whose friction enters the moment balance.
  unsigned int n_harmonics = all_harmonics;
};

/// An elastic foot in balance at one spin after the other, each found from the one before: contact, friction
/// and moment balance are one system, solved by the contact (fem::ContactDemand).
class BalancedContact
{
public:
  /// @p start is a contact near the first one asked for; nothing: the one that the foot has solved last.
  BalancedContact(std::shared_ptr<ElasticFoot> foot, const ContactBalance &balance,
                  std::optional<fem::ContactState> start = {});

  /// The contact at the spin @p omega [rad/s]. Throws fem::ContactFailure.
  fem::ContactState contact(double omega, Progress &progress = silent_progress());
  /// The first ContactBalance::n_harmonics of the load of a contact(), with its tilt if that is part of the
  /// balance.
  ring::LeaningLoad load_of(const fem::ContactState &state) const;

  std::size_t n_contact_solutions() const { return n_solved; }

private:
  fem::ContactDemand demand_at(double omega, const std::vector<double> &radii, double rotation) const;
  /// Starts from the previous contact state, even if the foot has been solved again since.
  fem::ContactState solve(const fem::ContactDemand &demand, double omega, Progress &progress);
  /// Uses T of the one ring with the same moment and first harmonic; its radius is part of the solution.
  fem::ContactState contact_on_one_ring(double omega, Progress &progress);

  const std::shared_ptr<ElasticFoot> foot;
  const ContactBalance balance;
  double one_radius;       ///< of the one ring in the solution before [m]
  double one_rotation = 0; ///< [rad]
  std::size_t n_solved = 0;
  std::optional<fem::ContactState> before;
};

} // namespace stemware::pipeline
