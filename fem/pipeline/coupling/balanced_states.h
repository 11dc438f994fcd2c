#pragma once

#include "ring_model/self_consistent_ring.h"

#include <cstddef>
#include <map>
#include <vector>

namespace stemware::pipeline
{

/// Balances of load, friction and moments at one spin after the other, each kept.
///
/// A balance starts from those already known nearby: what M_N differs there from the first harmonic's closed
/// form is extrapolated to the new spin, so that on a path of close spins the first load tried is usually the
/// balanced one.
class BalancedStates
{
public:
  /// @p spin_scale v / R [rad/s]; the marks of glass and table stand at @p orientation.
  BalancedStates(ring::SelfConsistentRing glass, double spin_scale,
                 const ring::Orientation &orientation = {});

  /// The balance at @p omega [rad/s]. Throws as ring::SelfConsistentRing::at().
  const ring::RingEquilibrium &at(double omega);

  /// Spins solved so far.
  std::size_t size() const { return states.size(); }

private:
  struct State
  {
    ring::RingEquilibrium balance;
    Eigen::Vector2d correction; ///< M_N minus that of the first harmonic in balance [N m]
  };
  using States = std::map<double, State>;

  /// Known spins near @p omega, nearest first, apart from each other like points of a good interpolation.
  std::vector<States::const_iterator> neighbours(double omega) const;

  ring::BalanceStart start_near(double omega) const;

  const ring::SelfConsistentRing glass;
  const double reach; ///< spins further away say nothing
  const ring::Orientation orientation;
  States states;
};

} // namespace stemware::pipeline
