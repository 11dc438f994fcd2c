#pragma once

#include "fem/pipeline/coupling/balanced_load.h"

namespace stemware::pipeline
{

/// Change of the load between two feet: found at rest and at one spin, linear in the spin.
struct LoadChange
{
  unsigned int n_harmonics = 0;  ///< of the rows
  Eigen::VectorXd at_rest = {};  ///< ring::Sample::coefficients()
  Eigen::VectorXd per_spin = {}; ///< [s/rad]; empty without a balance at that spin
};

/// Returns the change at rest from @p own to @p changed, loads on the same number of rings.
LoadChange change_at_rest(const BalancedLoad &own, const BalancedLoad &changed);

/// Returns LoadChange::per_spin by the change at the spin @p omega [rad/s]; @p at_rest: change_at_rest().
/// Empty without a balance there.
Eigen::VectorXd change_per_spin(const BalancedLoad &own, const BalancedLoad &changed,
                                const LoadChange &at_rest, double omega);

/// Returns the load @p own plus @p change at every spin. Report and contacts are those of @p changed, whose
/// contacts are costly.
BalancedLoad changed_load(const BalancedLoad &own, const BalancedLoad &changed, const LoadChange &change);

} // namespace stemware::pipeline
