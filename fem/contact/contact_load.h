#pragma once

#include "fem/contact/contact_newton.h"
#include "ring_model/load/ring_stack.h"

#include <optional>
#include <utility>
#include <vector>

namespace stemware::fem
{

/// Load lambda(theta) of a contact on the table: harmonics on concentric rings, theta in the slip frame,
/// with extent and pointwise load.
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

  double rotation = 0;    ///< rotation of the single ring to the direction of M_N [rad]; 0 by symmetry unless
                          ///< friction deforms the foot
  double mean_radius = 0; ///< sum f r / sum f [m]
  double contact_fraction = 0;                 ///< ContactExtent::area_share
  std::optional<double> azimuth_fraction = {}; ///< ContactExtent::azimuth_share
  double peak_pressure = 0;                    ///< [Pa]
  double least = 0;                            ///< least_load() [N/rad]
  std::vector<AzimuthLoad> pointwise; ///< lambda by azimuth, sorted, not truncated to a Fourier series

  /// Returns the load rotated counter-clockwise by @p angle [rad].
  ContactLoad rotated(double angle) const;
};

/// Weights of a point force on rings: Lagrange polynomials of the rings' radii, all radial moments of orders
/// below their number exact. Far from the rings the two outermost ones share the force linearly.
class RingWeights
{
public:
  /// Throws std::invalid_argument unless the radii are positive and ascending.
  explicit RingWeights(std::vector<double> radii);

  /// Returns the shares of a force at @p radius, one for each ring. Valid until the next call.
  const Eigen::VectorXd &at(double radius) const;

private:
  std::vector<double> radii;
  const double per_unit;   ///< scale of the distances that keeps their products within floating-point range
                           ///< [1/m]
  Eigen::VectorXd factors; ///< 1 / prod_k (r_j - r_k) per_unit
  mutable Eigen::VectorXd shares;
};

/// Projects a contact solution onto rings of @p ring_radii (empty: one ring), from the law's own quadrature
/// points: harmonics_of() with extent, minimum and pointwise load. Throws std::invalid_argument without a
/// load.
ContactLoad extract_load(const TableLaw &law, const ContactSolution &solution, unsigned int n_harmonics,
                         const std::vector<double> &ring_radii = {});

/// Returns the minimum of a load given at azimuths, in their order round the rim [N/rad]. Equidistant
/// azimuths: minimum of the trigonometric interpolant between the neighbours of the lowest value. Other
/// azimuths: minimum of the parabola through these three values. 0 if the lowest value is 0.
double least_load(const std::vector<AzimuthLoad> &pointwise);

/// Returns the number of parts into which TableLaw::load() divides each contact line so that its quadrature
/// points resolve the radial moments of @p n_rings rings.
unsigned int n_line_parts(std::size_t n_rings);

/// Returns the smallest and largest radius [m] of the points of @p load whose force exceeds rounding of the
/// largest.
std::pair<double, double> loaded_band(const TableLoad &load);

/// Returns the harmonics 0 ... @p n_harmonics of @p forces: a_n = sum f_i cos(n theta_i) / pi, b_n likewise,
/// a_0 = sum f_i / (2 pi). On rings with @p radii [m], ring j gets f_i l_j(r_i), with the Lagrange
/// polynomials l_j of the radii. With J rings sum_j r_j^k lambda_j equals the load's radial moment of order k
/// at every azimuth, k < J; forces outside the radii are extrapolated. Without radii one ring has the whole
/// force. The @p forces may belong to one of the @p parts of a surface.
///
/// Leaves extent, minimum and pointwise load empty. Throws std::invalid_argument without a load, or if the
/// radii are not positive and ascending.
ContactLoad harmonics_of(const std::vector<PointForce> &forces, unsigned int n_harmonics,
                         const std::vector<double> &radii = {}, const SurfaceParts &parts = {});

} // namespace stemware::fem
