#pragma once

#include "ring_model/load/load_functional.h"

#include <vector>

namespace stemware::ring
{
/// Friction of the table on the ring, in the slip frame, about the ring's centre.
struct Wrench
{
  double torque;  ///< tau_z [N m], counter-clockwise positive
  double force_x; ///< T_x [N], along the motion: negative
  double force_y; ///< T_y [N], to the left of the motion
};

/// Components of the Wrench of a stack of rings as linear functionals of its load.
struct FrictionFunctionals
{
  LoadFunctional drag;   ///< T_x [N]
  LoadFunctional side;   ///< T_y [N]
  LoadFunctional torque; ///< tau_z [N m]

  /// Evaluates the functionals for @p load. @throws std::invalid_argument if it has another number of
  /// rings.
  Wrench operator()(const RingStack &load) const;
};

/**
 * Coulomb friction with one coefficient on rings that slide with speed v along x and spin with omega about z.
 * The friction on each point of a ring is mu lambda against the slip velocity of the point, (v - omega r sin
 * theta, omega r cos theta):
 *
 *   tau_z = mu r int lambda (v sin theta - omega r) / |v_rel| dtheta
 *
 * and likewise T_x, T_y; a stack sums over its rings. (The paper prints tau_z with the opposite sign;
 * docs/theory/model.md.) All three are linear in lambda, and exact to rounding at every slip ratio eps_j =
 * omega r_j / v. With the kernels P_n, K_n, U_n of FrictionKernels, c_n = cos(n pi / 2) and s_n = sin(n pi /
 * 2):
 *
 *   T_x   = -mu sum_j     sum_n   (c_n a_{j,n} + s_n b_{j,n}) U_n(eps_j)
 *   T_y   = -mu sum_j     sum_n n (c_n b_{j,n} - s_n a_{j,n}) P_n(eps_j)
 *   tau_z =  mu sum_j r_j sum_n   (c_n a_{j,n} + s_n b_{j,n}) K_n(eps_j)
 *
 * @param mu     Coefficient of friction, >= 0.
 * @param radii  r_j [m].
 * @param n_max  Highest harmonic that counts.
 * @param omega  Spin [rad/s], counter-clockwise positive.
 * @param speed  Sliding speed v >= 0 [m/s].
 * @throws std::invalid_argument if a value is not finite, mu or v < 0, or the rings neither slide nor spin.
 */
FrictionFunctionals friction_functionals(double mu, const std::vector<double> &radii, unsigned int n_max,
                                         double omega, double speed);

/// Returns the wrench of friction_functionals() on @p load. Throws as friction_functionals().
Wrench coulomb_wrench(double mu, const RingStack &load, double omega, double speed);
} // namespace stemware::ring
