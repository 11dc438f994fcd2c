#pragma once

#include "fem/pipeline/coupling/balanced_load.h"
#include "fem/pipeline/coupling/elastic_foot.h"

#include <cstddef>
#include <map>
#include <memory>
#include <optional>

namespace stemware::pipeline
{

/// What an elastic foot is to be in balance with.
struct ContactBalance
{
  MomentBalance moments;
  /// Whether the weight of the leaning glass is part of the moment balance.
  bool tilts = false;
  /// Harmonics of the rings whose friction enters the moment balance.
  unsigned int n_harmonics = all_harmonics;
};

/// An elastic foot in balance at one spin after the other: contact, friction and moment balance are one
/// system, solved by the contact (fem::ContactDemand). All loads are kept, of contacts the last one.
class BalancedContact
{
public:
  /// @p start is a contact near the first one asked for; nothing: the one that the foot has solved last.
  BalancedContact(std::shared_ptr<const ElasticFoot> foot, const ContactBalance &balance,
                  std::optional<fem::ContactState> start = {});

  /// The load at the spin @p omega [rad/s], of all harmonics. Throws fem::ContactFailure.
  const LeaningLoad &at(double omega);

  /// The contact itself; solved again.
  fem::ContactState contact(double omega, Progress &progress = silent_progress());

  std::size_t n_spins() const { return loads.size(); }
  std::size_t n_contact_solutions() const { return n_solved; }

private:
  fem::ContactDemand demand_at(double omega, const std::vector<double> &radii, double rotation) const;
  /// From the contact before, even where the foot has been used for others since.
  fem::ContactState solve(const fem::ContactDemand &demand, double omega, Progress &progress);
  /// With T of the one ring that carries moment and first harmonic, whose radius is part of the solution.
  fem::ContactState contact_on_one_ring(double omega, Progress &progress);

  const std::shared_ptr<const ElasticFoot> foot;
  const ContactBalance balance;
  std::map<double, LeaningLoad> loads;
  double one_radius;       ///< of the one ring in the solution before [m]
  double one_rotation = 0; ///< [rad]
  std::size_t n_solved = 0;
  std::optional<fem::ContactState> before;
  std::size_t place_of_before; ///< among the foot's solutions
};

/// The load of a contact, with its tilt where that is part of the balance.
LeaningLoad leaning_load(const fem::ContactState &state, bool tilts);

} // namespace stemware::pipeline
