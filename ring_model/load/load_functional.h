#pragma once

#include "ring_model/load/ring_stack.h"

#include <Eigen/Core>

namespace stemware::ring
{
/// Linear function of a load: sum_j sum_n (a(n, j) a_{j,n} + b(n, j) b_{j,n}), with a_{j,n}, b_{j,n} [N/rad]
/// the coefficients of ring j. Its coefficients have the unit of the result per N/rad. Shape [n_max + 1,
/// rings].
struct LoadFunctional
{
  Eigen::ArrayXXd a; ///< coefficients of the cosines
  Eigen::ArrayXXd b; ///< coefficients of the sines; b(0, j) = 0

  /// Returns the value for @p load. Harmonics missing in the load or in the functional count as 0. Throws
  /// std::invalid_argument if the load has another number of rings.
  double operator()(const RingStack &load) const;

  /// Returns the functional that gives this functional's value for the load rotated counter-clockwise by @p
  /// angle [rad].
  LoadFunctional of_rotated(double angle) const;
};

/// Returns the functional with @p factor times the value.
inline LoadFunctional operator*(double factor, const LoadFunctional &functional)
{
  return { factor * functional.a, factor * functional.b };
}

/// Returns the sum of functionals of the same shape.
inline LoadFunctional operator+(const LoadFunctional &one, const LoadFunctional &other)
{
  return { one.a + other.a, one.b + other.b };
}
} // namespace stemware::ring
