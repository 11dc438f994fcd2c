#pragma once

#include "fem/contact/contact_newton.h"

#include <utility>
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
  double minimum = 0;                 ///< least_load() [N/rad]
  std::vector<AzimuthLoad> pointwise; ///< lambda itself by azimuth, sorted; what the series stands for

  std::size_t n_rings() const { return radii.size(); }
  std::size_t n_harmonics() const { return a.front().size() - 1; }

  /// The load turned counter-clockwise by @p angle [rad].
  LoadHarmonics turned(double angle) const;
};

/// A linear function of a load, sum_j sum_n a[j][n] a_jn + b[j][n] b_jn, in units of its value per N/rad.
struct LoadFunction
{
  std::vector<std::vector<double>> a; ///< shape [n_rings, n_harmonics + 1]; harmonics beyond do not count
  std::vector<std::vector<double>> b;

  double operator()(const LoadHarmonics &load) const;

  /// What this is of the load turned counter-clockwise by @p angle [rad], as a function of the load itself.
  LoadFunction of_turned(double angle) const;
};

LoadFunction operator*(double factor, LoadFunction function);
/// Of functions of the same shape.
LoadFunction operator+(LoadFunction one, const LoadFunction &other);

/// How rings share a force by its radius: the values there of the Lagrange polynomials of their radii, so
/// that radial moments up to one less than the number of rings are kept. One ring gets all.
class RingShares
{
public:
  /// Throws std::invalid_argument unless the radii are positive and ascending.
  explicit RingShares(std::vector<double> radii);

  /// Shares of a force at @p radius, one for each ring; valid until the next call.
  const Eigen::VectorXd &at(double radius) const;

private:
  std::vector<double> radii;
  const double unit;                ///< of distances, in which their products neither vanish nor overflow [m]
  std::vector<double> denominators; ///< prod_k (r_j - r_k) / unit
  mutable Eigen::VectorXd shares;
};

/// The load of nodal @p forces on circles @p radii [m] and equidistant azimuth lines, shape [n_radii,
/// n_lines] [N]: on rings of @p ring_radii, on the one that carries moment and first harmonic where these are
/// empty. With the pointwise quantities, those of the lines. Throws std::invalid_argument when there is no
/// load.
LoadHarmonics harmonics_on_lines(const Eigen::MatrixXd &forces, const Eigen::VectorXd &radii,
                                 unsigned int n_harmonics, const std::vector<double> &ring_radii);

/// Harmonics 0 ... @p n_harmonics of a contact solution from the law's own quadrature points, on rings of
/// @p ring_radii, on one ring where these are empty: harmonics_of() with contact_fraction, minimum and
/// pointwise. Throws std::invalid_argument when there is no load.
LoadHarmonics extract_load(const TableLaw &law, const ContactSolution &solution, unsigned int n_harmonics,
                           const std::vector<double> &ring_radii = {});

/// Least of a load that is known at azimuths, in their order round the rim: between the lowest value and its
/// neighbours by the parabola through the three; 0 where the lowest is [N/rad].
double least_load(const std::vector<AzimuthLoad> &pointwise);

/// Into how many parts a contact line is to be cut for its quadrature points to know the radial moments that
/// @p n_rings rings take over (TableLaw::load()).
unsigned int parts_of_lines(std::size_t n_rings);

/// Least and largest radius [m] of those points of @p load that are more than rounding of the largest.
std::pair<double, double> loaded_band(const TableLoad &load);

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
