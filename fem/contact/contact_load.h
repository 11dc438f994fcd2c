#pragma once

#include "fem/contact/contact_newton.h"
#include "ring_model/load/ring_stack.h"

#include <optional>
#include <utility>
#include <vector>

namespace stemware::fem
{

/// Load lambda(theta) of a contact on the table: harmonics on rings, extent, pointwise load; slip frame.
///
/// A single ring has the radius and the direction that give the load's moment M_N: radius |M_N| / (pi
/// sqrt(a_1^2 + b_1^2)), or sum f r^2 / sum f r without a moment. Several rings represent M_N by their radii.
struct ContactLoad : ring::RingStack
{
  /// Placeholder: one newton per radian on a ring of one metre.
  ContactLoad()
      : RingStack({ 1. }, { 0. }, 1.)
  {
  }
  explicit ContactLoad(ring::RingStack rings)
      : RingStack(std::move(rings))
  {
  }

  /// Rotation of the single ring to the direction of M_N [rad]; 0 unless friction deforms the foot.
  double rotation = 0;
  double mean_radius = 0;                      ///< sum f r / sum f [m]
  double contact_fraction = 0;                 ///< ContactExtent::area_share
  std::optional<double> azimuth_fraction = {}; ///< ContactExtent::azimuth_share
  double peak_pressure = 0;                    ///< [Pa]
  double least = 0;                            ///< least_load() [N/rad]
  std::vector<AzimuthValue> pointwise; ///< lambda by azimuth, sorted, not truncated to a Fourier series

  /// Returns the load rotated counter-clockwise by @p angle [rad].
  ContactLoad rotated(double angle) const;
};

/// Weights of a point force on rings: Lagrange polynomials of the radii, exact for radial moments of orders
/// below their number. Far from the rings, linear between the two outermost ones.
class RingWeights
{
public:
  /// Throws std::invalid_argument unless the radii are positive and ascending.
  explicit RingWeights(std::vector<double> radii);

  /// Returns the shares of a force at @p radius, one for each ring. Valid until the next call.
  const Eigen::VectorXd &at(double radius) const;

private:
  std::vector<double> radii;
  const double per_unit;   ///< scale that keeps products of distances in range [1/m]
  Eigen::VectorXd factors; ///< 1 / prod_k (r_j - r_k) per_unit
  mutable Eigen::VectorXd shares;
};

/// Projects a contact solution onto rings of @p ring_radii (empty: one ring): harmonics_of() the law's
/// quadrature points, with extent, minimum and pointwise load. Throws std::invalid_argument without a load.
ContactLoad extract_load(const TableLaw &law, const ContactSolution &solution, unsigned int n_harmonics,
                         const std::vector<double> &ring_radii = {});

/// Returns the minimum [N/rad] of a load at ordered azimuths, between the neighbours of the lowest value: of
/// the trigonometric interpolant (equidistant azimuths) or the parabola through the three values; 0 if the
/// lowest is 0.
double least_load(const std::vector<AzimuthValue> &pointwise);

/// Returns the parts of a line in TableLaw::load() that resolve the radial moments of @p n_rings rings.
unsigned int n_line_parts(std::size_t n_rings);

/// Returns the smallest and largest radius [m] of the points of @p load with a force above rounding.
std::pair<double, double> loaded_band(const TableLoad &load);

/// Returns the harmonics 0 ... @p n_harmonics of @p forces: a_n = sum f_i cos(n theta_i) / pi, b_n likewise,
/// a_0 = sum f_i / (2 pi). On rings with @p radii [m], ring j gets f_i l_j(r_i), with the Lagrange
/// polynomials l_j of the radii. With J rings, sum_j r_j^k lambda_j is the load's radial moment of order k <
/// J at every azimuth; forces outside the radii are extrapolated. Without radii: one ring. @p forces may
/// belong to one of the @p parts of a surface. Extent, minimum and pointwise load stay empty. Throws
/// std::invalid_argument without a load, and unless the radii are positive and ascending.
ContactLoad harmonics_of(const std::vector<PointForce> &forces, unsigned int n_harmonics,
                         const std::vector<double> &radii = {}, const SurfaceParts &parts = {});

} // namespace stemware::fem
