#pragma once

#include "ring_model/load_model.h"

#include <boost/math/interpolators/barycentric_rational.hpp>

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
 * m = 0.
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
  ResponseCurve(const std::vector<AngularLoad> &samples, double nominal_radius, double lift_off_ratio,
                double tolerance = 1e-8);

  /**
   * The interpolated load; N and M_N are exact.
   * @throws std::out_of_range beyond the last sample, std::invalid_argument for another normal force than the
   * samples', Tipping for m >= 2.
   */
  AngularLoad load(double normal_force, const Eigen::Vector2d &moment) const override;
  double radius() const override { return nominal; }
  double lift_off_ratio() const override { return onset; }
  double moment_ratio_limit() const override;

private:
  double nominal;
  double onset;
  double force;                                                       ///< normal force of all samples [N]
  double last_ratio;                                                  ///< moment ratio of the last sample
  std::vector<boost::math::barycentric_rational<double>> harmonics;   ///< a_n / a_0 over m for n = 2, 3, ...
  std::vector<boost::math::barycentric_rational<double>> ring_radius; ///< R_ring over m; one entry
};
} // namespace stemware::ring
