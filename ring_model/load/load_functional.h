#pragma once

#include "ring_model/load/ring_stack.h"

#include <vector>

namespace stemware::ring
{
/**
 * Linear function of a load: sum_j sum_n (a[j][n] a_{j,n} + b[j][n] b_{j,n}), with a_{j,n}, b_{j,n} [N/rad]
 * the coefficients of ring j. Its coefficients have the unit of the result per N/rad.
 */
struct LoadFunctional
{
  std::vector<std::vector<double>> a; ///< coefficients of the cosines: [ring][n], n = 0...n_max
  std::vector<std::vector<double>> b; ///< coefficients of the sines, as many; b[ring][0] = 0

  /**
   * Returns the value for @p load. Harmonics missing in the load or in the functional count as 0.
   * @throws std::invalid_argument if the load has another number of rings.
   */
  double operator()(const RingStack &load) const;

  /// Returns the functional that gives this functional's value for the load rotated counter-clockwise by @p
  /// angle [rad].
  LoadFunctional of_rotated(double angle) const;
};

LoadFunctional operator*(double factor, LoadFunctional functional);
/// Returns the sum of functionals of the same shape.
LoadFunctional operator+(LoadFunctional one, const LoadFunctional &other);
} // namespace stemware::ring
