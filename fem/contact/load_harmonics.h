#pragma once

#include "fem/contact/contact_newton.h"

#include <vector>

namespace stemware::fem
{

/// The load lambda(theta) that a contact solution puts on the table: the plain value handed to the ring.
///
/// lambda(theta) = a[0] + sum_n a[n] cos(n theta) + b[n] sin(n theta) [N/rad], theta in the slip frame,
/// counter-clockwise from x.
struct LoadHarmonics
{
  std::vector<double> a;       ///< [N/rad], size n_harmonics + 1
  std::vector<double> b;       ///< [N/rad], b[0] = 0
  double normal_force = 0;     ///< N [N]
  double moment_x = 0;         ///< sum y f [N m]
  double moment_y = 0;         ///< -sum x f [N m]
  double ring_radius = 0;      ///< |M_N| / (pi sqrt(a1^2 + b1^2)) [m]; without a moment sum f r^2 / sum f r
  double mean_radius = 0;      ///< sum f r / sum f [m]
  double contact_fraction = 0; ///< share of azimuth lines that carry load
  double minimum = 0;          ///< smallest pointwise load [N/rad]
  std::vector<AzimuthLoad> pointwise; ///< lambda itself by azimuth, sorted; what the series stands for
};

/// Harmonics 0 ... @p n_harmonics of a contact solution, a_n = sum f_i cos(n theta_i) / pi over the law's own
/// quadrature points (docs/method.md, "From forces to lambda"). Throws std::invalid_argument when there is no
/// load.
LoadHarmonics extract_load(const TableLaw &law, const ContactSolution &solution, unsigned int n_harmonics);

/// Sums over point forces; the part of extract_load() that needs no law. Leaves contact_fraction, minimum and
/// pointwise empty.
LoadHarmonics harmonics_of(const std::vector<PointForce> &forces, unsigned int n_harmonics);

/// Coulomb friction of the pressure as it lies in the plane, not gathered on a ring.
struct ResolvedFriction
{
  double torque = 0;  ///< about the ring's centre, counter-clockwise > 0 [N m]
  double force_x = 0; ///< along the direction of travel [N]
  double force_y = 0; ///< to the left of it [N]
};

/// Friction of point forces on a foot that slides at @p speed along x and yaws at @p omega: sum of -mu f
/// v_rel / |v_rel|, v_rel = (v - omega y, omega x). A point without slip carries no friction here.
ResolvedFriction resolved_friction(const std::vector<PointForce> &forces, double friction_coefficient,
                                   double omega, double speed);

} // namespace stemware::fem
