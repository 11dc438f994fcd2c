#pragma once

#include "ring_model/load_model.h"

#include <boost/math/interpolators/vector_barycentric_rational.hpp>

#include <cstddef>
#include <map>
#include <vector>

namespace stemware::ring
{
/**
 * Loads of one foot at several moment ratios, interpolated: what contact calculations provide for a foot that
 * is a body of revolution without friction coupling. There the shape depends on m alone and turns with the
 * moment.
 *
 * Each a_n / a_0 and the ring radius are interpolated in m by rational functions without poles (Floater and
 * Hormann, Numer. Math. 107 (2007) 315), infinitely smooth and exact at the nodes. Turning the load by 180
 * degrees maps m to -m and a_n to (-1)^n a_n, so the nodes are mirrored and the curve has the right parity at
 * m = 0. Where the load is less smooth in m, as at lift-off, the curve may consist of pieces, each
 * interpolated by itself.
 */
class ResponseCurve : public LoadModel
{
public:
  /**
   * @param samples        Loads with equal normal force and increasing moment, the first without moment (m =
   * 0).
   * @param nominal_radius R > 0 [m], for the moment ratio; the samples' ring radii may differ from it.
   * @param lift_off_ratio Moment ratio at which contact is first lost (infinite if it never is).
   * @param tolerance      Largest part of a_0 that a sample's harmonics may break the symmetry about the
   * direction of its moment; more shows a load that depends on more than m.
   * @throws std::invalid_argument saying which sample breaks which of these rules.
   */
  ResponseCurve(const std::vector<RingStack> &samples, double nominal_radius, double lift_off_ratio,
                double tolerance = 1e-8);

  /**
   * A curve in pieces, each interpolated by itself.
   *
   * @param pieces Each as @p samples above, the first load of a piece being the last one of the piece before.
   * @param chebyshev_nodes Whether the nodes gather at the ends of each piece like Chebyshev's: then the
   * polynomial through all of them is better than a rational function, and needs no mirrored nodes.
   * @throws std::invalid_argument as above, and for pieces that do not meet.
   */
  ResponseCurve(const std::vector<std::vector<RingStack>> &pieces, double nominal_radius,
                double lift_off_ratio, double tolerance = 1e-8, bool chebyshev_nodes = false);

  /**
   * The interpolated load; N and M_N are exact.
   * @throws std::out_of_range beyond the last sample, std::invalid_argument for another normal force than the
   * samples', Tipping for m >= 2.
   */
  RingStack rings(double normal_force, const Eigen::Vector2d &moment, const Slip &slip = {}) const override;
  double radius() const override { return nominal; }
  double lift_off_ratio() const override { return onset; }
  double moment_ratio_limit() const override;

private:
  /// Ring radius and a_n / a_0 for n = 2, 3, ... at a moment ratio.
  using Shape = std::vector<double>;
  using Interpolant = boost::math::vector_barycentric_rational<std::vector<double>, std::vector<Shape>>;

  double nominal;
  double onset;
  double force;                        ///< normal force of all samples [N]
  std::size_t shape_size;              ///< of every Shape
  std::map<double, Interpolant> curve; ///< pieces by the moment ratio of their last sample
};
} // namespace stemware::ring
