#pragma once

#include "ring_model/load/ring_stack.h"

namespace stemware::ring
{
/// Friction of the table on the ring, in the slip frame, about the ring's centre.
struct Wrench
{
  double torque;  ///< tau_z [N m], counter-clockwise positive
  double force_x; ///< T_x [N], along the motion: negative
  double force_y; ///< T_y [N], to the left of the motion
};

/**
 * Coulomb friction with one coefficient on a ring that slides with speed v along x and spins with omega about
 * z. Every point of the ring feels mu lambda against its own slip velocity (v - omega R sin theta, omega R
 * cos theta):
 *
 *   tau_z = mu R int lambda (v sin theta - omega R) / |v_rel| dtheta
 *
 * and likewise T_x, T_y; those of a stack are the sums over its rings. (The paper prints tau_z with the
 * opposite sign; docs/theory/model.md.) All of it is linear in lambda, so each harmonic acts through one
 * kernel of eps = omega R / v.
 */
class CoulombRing
{
public:
  /// @param friction_coefficient mu >= 0. @throws std::invalid_argument otherwise.
  explicit CoulombRing(double friction_coefficient);

  /// mu.
  double friction_coefficient() const { return mu; }

  /**
   * Torque and friction force, exact to rounding at every slip ratio.
   * @param omega Spin [rad/s], counter-clockwise positive.
   * @param speed Sliding speed v >= 0 [m/s].
   * @throws std::invalid_argument if a value is not finite, v < 0, or the ring neither slides nor spins.
   */
  Wrench wrench(const RingStack &load, double omega, double speed) const;

  /// Power lost to friction, -(T.v + tau_z omega) [W]: never negative where lambda >= 0.
  double dissipation(const RingStack &load, double omega, double speed) const;

  /**
   * A-priori bound [N m] on the change of tau_z when the harmonics above @p n_max are left out:
   * mu sum_j r_j sum_{n > n_max} sqrt(a_{j,n}^2 + b_{j,n}^2) |K_n(eps_j)|.
   */
  double truncation_bound(const RingStack &load, unsigned int n_max, double omega, double speed) const;

private:
  double mu;
};
} // namespace stemware::ring
