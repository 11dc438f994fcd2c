#pragma once

#include "ring_model/friction_functionals.h"
#include "ring_model/moment_balance.h"
#include "ring_model/motion.h"
#include "ring_model/terminal_spin.h"

namespace stemware::ring
{
/**
 * Ring with a first-harmonic load that balances all moments of its closure at every spin, in closed form.
 *
 * The friction enters the moment (arm h), the moment the load, the load the friction; for a first harmonic
 * this is a linear system. With kappa = mu h / (pi R) and (a', b') the coefficients without friction:
 *
 *   a_1 = (a' + kappa (a_0 U_0 + b' U_1)) / (1 + kappa^2 U_1 P_1),   b_1 = b' - kappa a_1 P_1.
 *
 * The load is formal: negative somewhere (tensile) if the moment ratio exceeds 1. docs/theory/closures.md.
 */
class FirstHarmonicRing
{
public:
  /// @throws std::invalid_argument if the motion or the radius [m] is not allowed, or the friction depends on
  /// the slip.
  FirstHarmonicRing(Closure closure, const Motion &motion, double radius);

  /// Returns the self-consistent load at the spin @p omega [rad/s].
  RingStack load(double omega) const;

  /// Returns torque and friction at the spin @p omega [rad/s] under load(omega).
  Wrench wrench(double omega) const;

  /// Returns the yaw torque [N m] at the spin @p omega [rad/s].
  double torque(double omega) const { return wrench(omega).torque; }

  /// Returns the terminal spin reached from rest.
  TerminalSpin terminal_spin() const;

private:
  Motion motion;
  double radius;
  double coupling;       ///< kappa = mu h / (pi R)
  Eigen::Vector2d a1_b1; ///< (a_1, b_1) without friction [N/rad]
};
} // namespace stemware::ring
