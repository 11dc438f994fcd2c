#pragma once

#include "ring_model/friction_law.h"
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

  /// Evaluates the functionals for @p load. Throws std::invalid_argument unless the number of rings agrees.
  Wrench operator()(const RingStack &load) const;
};

/// Returns the friction under @p law on rings that slide with speed v along x and spin with omega about z.
/// Friction acts with mu lambda against the slip velocity of each point, v_rel = (v - omega r sin theta,
/// omega r cos theta):
///
///   tau_z = r int mu lambda (v sin theta - omega r) / |v_rel| dtheta
///
/// and likewise T_x, T_y; a stack sums over its rings. (The paper prints tau_z with the opposite sign;
/// docs/theory/model.md.) All three are linear in lambda, even if mu depends on |v_rel|. If mu is constant,
/// they are exact to rounding at every slip ratio eps_j = omega r_j / v, with the kernels P_n, K_n, U_n of
/// FrictionKernels, c_n = cos(n pi / 2) and s_n = sin(n pi / 2):
///
///   T_x   = -mu sum_j     sum_n   (c_n a_{j,n} + s_n b_{j,n}) U_n(eps_j)
///   T_y   = -mu sum_j     sum_n n (c_n b_{j,n} - s_n a_{j,n}) P_n(eps_j)
///   tau_z =  mu sum_j r_j sum_n   (c_n a_{j,n} + s_n b_{j,n}) K_n(eps_j)
///
/// @p radii: r_j [m]. @p n_max: highest harmonic of the sums. @p omega: spin [rad/s], counter-clockwise
/// positive. @p speed: sliding speed v >= 0 [m/s]. Throws std::invalid_argument if a value is not finite, if
/// v < 0, or if the rings neither slide nor spin; and as friction_kernels().
FrictionFunctionals friction_functionals(const FrictionLaw &law, const std::vector<double> &radii,
                                         unsigned int n_max, double omega, double speed);

/// Returns friction_functionals() under the law of @p motion, at its orbit speed.
FrictionFunctionals friction_functionals(const Motion &motion, const std::vector<double> &radii,
                                         unsigned int n_max, double omega);

/// Returns the friction on @p load under law and orbit speed of @p motion. Throws as friction_functionals().
Wrench wrench(const Motion &motion, const RingStack &load, double omega);

/// Returns the friction under @p law on @p load, whose centre has the @p velocity [m/s]; force and velocity
/// in the frame of @p load. Throws as friction_functionals().
Wrench wrench(const FrictionLaw &law, const RingStack &load, const Eigen::Vector2d &velocity, double omega);

/// Returns the friction on @p load under Coulomb's law. Throws as friction_functionals().
Wrench coulomb_wrench(double mu, const RingStack &load, double omega, double speed);

/// Torque tau_z of friction on one load at one spin, with the load cut after n harmonics:
///
///     const TorqueByHarmonics torque(motion, load, omega);
///     torque.change(2); // effect of the second harmonic on tau_z [N m]
///
/// tau_z(n) = sum_{k <= n} tau_k, where tau_k is the share of harmonic k of all rings. No balance is solved
/// again. An n above the load's highest harmonic means the whole load.
class TorqueByHarmonics
{
public:
  /// Friction under the law of @p motion, at its orbit speed. Throws as friction_functionals().
  TorqueByHarmonics(const Motion &motion, const RingStack &load, double omega);

  /// Returns Delta tau_z(n) = tau_z(n) - tau_z(1) [N m].
  double change(unsigned int n) const;
  /// Returns tau_z(all) - tau_z(n) [N m].
  double rest(unsigned int n) const;
  /// Returns an a-priori bound on |rest(n)| [N m]: sum_j sum_{k > n} |lambda_{j,k}| |K_{j,k}|, with
  /// |lambda_{j,k}| = sqrt(a_{j,k}^2 + b_{j,k}^2) and the coefficients K_{j,k} of the torque functional.
  double bound(unsigned int n) const;

private:
  std::vector<double> shares; ///< tau_k [N m]
  std::vector<double> bounds; ///< bounds on |tau_k| [N m]
};
} // namespace stemware::ring
