#pragma once

#include "ring_model/load_model.h"

#include <vector>

namespace stemware::ring
{
/**
 * Rigid ring pressed on a unilateral foundation (no tension) with a pressure law of exponent p:
 *
 *   lambda(theta) = A max(0, cos(theta - beta) - c)^p.
 *
 * p = 1: flat rim on a linear elastic mat (Winkler); p = 3/2: rim of circular cross-section on a mat. The
 * whole ring is loaded (c < -1) up to the moment ratio 2p/(p+1), a part of it up to tipping at m = 2.
 * Derivation, closed forms and recurrences: docs/theory/load_models.md.
 */
class UnilateralFoundation : public LoadModel
{
public:
  /**
   * @param radius      R > 0 [m].
   * @param exponent    p > 0.
   * @param n_harmonics Highest harmonic of the returned loads. With lift-off a_n decays like n^{-1-p} only,
   * but its factor in the torque, K_n(eps), decays like |eps|^n.
   * @throws std::invalid_argument if a value is not allowed.
   */
  UnilateralFoundation(double radius, double exponent, unsigned int n_harmonics = 128);

  RingStack rings(double normal_force, const Eigen::Vector2d &moment) const override;
  double radius() const override { return ring_radius; }
  /// Returns the moment ratio above which a part of the ring is unloaded.
  double lift_off_ratio() const { return 2. * p / (p + 1.); }

  /**
   * Edge parameter c at the moment ratio @p moment_ratio, 0 <= m < 2: the cosine of the angle at which
   * contact ends, or c < -1 for full contact (minus infinity at m = 0).
   * @throws Tipping for m >= 2, std::invalid_argument for m < 0 or not finite.
   */
  double edge(double moment_ratio) const;

  /// a_n / a_0 for n = 0...n_harmonics, the load's maximum at theta = 0. Throws as edge().
  std::vector<double> shape(double moment_ratio) const;

private:
  /// m for the inverse edge 0 <= kappa = -1/c <= 1 (full contact).
  double full_contact_ratio(double kappa) const;

  /// m for 0 < s = (1 - c)/2 <= 1 (lift-off).
  double partial_contact_ratio(double s) const;

  double ring_radius;
  double p;
  unsigned int n_max;
};
} // namespace stemware::ring
