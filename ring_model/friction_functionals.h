#pragma once

#include "ring_model/load/load_functional.h"

#include <vector>

namespace stemware::ring
{
/// Coulomb friction of the table on a stack of rings, in the slip frame, about the rings' centre.
struct FrictionFunctionals
{
  LoadFunctional drag;   ///< T_x [N], along the motion
  LoadFunctional side;   ///< T_y [N], to the left of the motion
  LoadFunctional torque; ///< tau_z [N m], counter-clockwise positive
};

/**
 * T_x, T_y and tau_z of a stack as functions of its load, exact to rounding at every slip ratio eps_j = omega
 * r_j / v. With the kernels P_n, K_n, U_n of FrictionKernels, c_n = cos(n pi / 2) and s_n = sin(n pi / 2):
 *
 *   T_x   = -mu sum_j     sum_n   (c_n a_{j,n} + s_n b_{j,n}) U_n(eps_j)
 *   T_y   = -mu sum_j     sum_n n (c_n b_{j,n} - s_n a_{j,n}) P_n(eps_j)
 *   tau_z =  mu sum_j r_j sum_n   (c_n a_{j,n} + s_n b_{j,n}) K_n(eps_j)
 *
 * @param mu     Coefficient of friction.
 * @param radii  r_j [m].
 * @param n_max  Highest harmonic that counts.
 * @param omega  Spin [rad/s], counter-clockwise positive.
 * @param speed  Sliding speed v >= 0 [m/s].
 * @throws std::invalid_argument if a value is not finite, v < 0, or the rings neither slide nor spin.
 */
FrictionFunctionals friction_functionals(double mu, const std::vector<double> &radii, unsigned int n_max,
                                         double omega, double speed);
} // namespace stemware::ring
