#pragma once

#include "fem/contact/contact_newton.h"
#include "ring_model/load/ring_stack.h"

#include <optional>
#include <utility>
#include <vector>

namespace stemware::fem
{

/// The load lambda(theta) that a contact puts on the table: on concentric rings, theta in the slip frame, and
/// what their series do not say.
///
/// One ring alone has the radius and the direction of the load's moment M_N: |M_N| / (pi sqrt(a_1^2 +
/// b_1^2)), and sum f r^2 / sum f r where there is none. Several carry M_N by their radii.
struct ContactLoad : ring::RingStack
{
  /// A newton per radian on a ring of a metre, to be replaced.
  ContactLoad()
      : RingStack({ 1. }, { 0. }, 1.)
  {
  }
  explicit ContactLoad(ring::RingStack rings)
      : RingStack(std::move(rings))
  {
  }

  double rotation = 0; ///< by which the one ring has been turned to the direction of M_N [rad]; 0 by symmetry
                       ///< but for friction that deforms the foot
  double mean_radius = 0;                      ///< sum f r / sum f [m]
  double contact_fraction = 0;                 ///< ContactExtent::area_share
  std::optional<double> azimuth_fraction = {}; ///< ContactExtent::azimuth_share
  double peak_pressure = 0;                    ///< [Pa]
  double least = 0;                            ///< least_load() [N/rad]
  std::vector<AzimuthLoad> pointwise; ///< lambda itself by azimuth, sorted; what the series stand for

  /// The load turned counter-clockwise by @p angle [rad].
  ContactLoad turned(double angle) const;
};

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
  const double per_unit;   ///< of distances, in which their products neither vanish nor overflow [1/m]
  Eigen::VectorXd factors; ///< 1 / prod_k (r_j - r_k) per_unit
  mutable Eigen::VectorXd shares;
};

/// Gathers a contact solution on rings of @p ring_radii, on one ring where these are empty, from the law's
/// own quadrature points: harmonics_of() with extent, least and pointwise. Throws
/// std::invalid_argument when there is no load.
ContactLoad extract_load(const TableLaw &law, const ContactSolution &solution, unsigned int n_harmonics,
                         const std::vector<double> &ring_radii = {});

/// Least of a load that is known at azimuths, in their order round the rim: between the lowest value and its
/// neighbours by the parabola through the three; 0 where the lowest is [N/rad].
double least_load(const std::vector<AzimuthLoad> &pointwise);

/// Into how many parts a contact line is to be cut for its quadrature points to know the radial moments that
/// @p n_rings rings take over (TableLaw::load()).
unsigned int parts_of_lines(std::size_t n_rings);

/// Least and largest radius [m] of those points of @p load that are more than rounding of the largest.
std::pair<double, double> loaded_band(const TableLoad &load);

/// Harmonics 0 ... @p n_harmonics of @p forces: a_n = sum f_i cos(n theta_i) / pi (a_0 half of that), b_n
/// likewise. Of rings with the given @p radii [m] ring j gets f_i l_j(r_i), l_j the Lagrange polynomials of
/// the radii: with J rings sum_j r_j^k lambda_j equals the load's radial moment of order k at every azimuth,
/// k < J; forces outside the radii are extrapolated. Without radii one ring gets all. @p forces may be those
/// of one of the @p parts of a surface.
///
/// Leaves the extent, least and pointwise empty. Throws std::invalid_argument when there is no load or
/// the radii are not positive and ascending.
ContactLoad harmonics_of(const std::vector<PointForce> &forces, unsigned int n_harmonics,
                         const std::vector<double> &radii = {}, const SurfaceParts &parts = {});

} // namespace stemware::fem
