#pragma once

#include "ring_model/friction_functionals.h"
#include "ring_model/moment_balance.h"
#include "ring_model/motion.h"

namespace stemware::ring
{
/// Load and friction that satisfy all balances at one spin, in the slip frame.
struct RingEquilibrium
{
  RingStack load;      ///< normal load
  Wrench friction;     ///< T and tau_z of the table on the ring
  double moment_ratio; ///< m = |M_N| / (N R / 2)
};

/// Ring with a first-harmonic load whose load, friction and hand force satisfy all balances at once: T enters
/// M_N, M_N enters lambda, lambda enters T. Exact for a linear support in full contact; for m > 1 the load is
/// tensile somewhere (docs/theory/closures.md).
class SelfConsistentRing
{
public:
  /// @p radius: R > 0 [m]. Throws std::invalid_argument if the radius or the motion is not allowed.
  SelfConsistentRing(Closure closure, const Motion &motion, double radius);

  /// Returns the equilibrium at the spin @p omega [rad/s]. Throws NoBalance if the moments cannot balance.
  RingEquilibrium at(double omega) const;

  /// Returns the yaw torque [N m] at the spin @p omega [rad/s]; throws as at().
  double torque(double omega) const { return at(omega).friction.torque; }

private:
  Closure closure;
  Motion motion;
  double radius;
};
} // namespace stemware::ring
