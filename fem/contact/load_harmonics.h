#pragma once

#include "fem/contact/contact_newton.h"

#include <vector>

namespace stemware::fem
{

/// The load lambda(theta) that a contact solution puts on the table, gathered on J concentric rings.
///
/// Ring j carries lambda_j(theta) = a[j][0] + sum_n a[j][n] cos(n theta) + b[j][n] sin(n theta) [N/rad],
/// theta in the slip frame, counter-clockwise from x; the load of the whole contact is the sum over the
/// rings. All rings have the harmonics 0 ... n_harmonics().
struct LoadHarmonics
{
  std::vector<double> radii;          ///< of the rings, ascending [m]
  std::vector<std::vector<double>> a; ///< [N/rad], shape [n_rings(), n_harmonics() + 1]
  std::vector<std::vector<double>> b; ///< [N/rad], b[j][0] = 0
  double normal_force = 0;            ///< N [N]
  double moment_x = 0;                ///< sum y f [N m]
  double moment_y = 0;                ///< -sum x f [N m]
  double mean_radius = 0;             ///< sum f r / sum f [m]
  double contact_fraction = 0;        ///< share of azimuth lines that carry load
  double minimum = 0;                 ///< smallest pointwise load [N/rad]
  std::vector<AzimuthLoad> pointwise; ///< lambda itself by azimuth, sorted; what the series stands for

  std::size_t n_rings() const { return radii.size(); }
  std::size_t n_harmonics() const { return a.front().size() - 1; }

  /// The load turned counter-clockwise by @p angle [rad].
  LoadHarmonics turned(double angle) const;
};

/// Harmonics 0 ... @p n_harmonics of a contact solution on one ring, from the law's own quadrature points:
/// harmonics_of() with contact_fraction, minimum and pointwise. Throws std::invalid_argument when there is no
/// load.
LoadHarmonics extract_load(const TableLaw &law, const ContactSolution &solution, unsigned int n_harmonics);

/// Harmonics of @p forces on one ring: a_n = sum f_i cos(n theta_i) / pi (a_0 half of that), b_n likewise,
/// and the radius that carries the moment, |M_N| / (pi sqrt(a_1^2 + b_1^2)); without a moment sum f r^2 / sum
/// f r. Leaves contact_fraction, minimum and pointwise empty. Throws std::invalid_argument when there is no
/// load.
LoadHarmonics harmonics_of(const std::vector<PointForce> &forces, unsigned int n_harmonics);

/// Harmonics of @p forces on rings of the given @p radii [m]: ring j gets f_i l_j(r_i), l_j the Lagrange
/// polynomials of the radii. With J rings sum_j r_j^k lambda_j equals the load's radial moment of order k at
/// every azimuth, k < J; forces outside the radii are extrapolated. Throws std::invalid_argument when there
/// is no load or the radii are not positive and ascending.
LoadHarmonics harmonics_of(const std::vector<PointForce> &forces, unsigned int n_harmonics,
                           const std::vector<double> &radii);

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
