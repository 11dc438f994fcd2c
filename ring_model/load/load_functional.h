#pragma once

#include "ring_model/load/ring_stack.h"

#include <Eigen/Core>

namespace stemware::ring
{
/// Linear functional of a load: sum_j sum_n (a(n, j) a_{j,n} + b(n, j) b_{j,n}) with the coefficients
/// a_{j,n}, b_{j,n} [N/rad] of ring j. Unit of a and b: the result's per N/rad. Shapes [n_max + 1, rings].
struct LoadFunctional
{
  Eigen::ArrayXXd a; ///< coefficients of the cosines
  Eigen::ArrayXXd b; ///< coefficients of the sines; b(0, j) = 0

  /// Returns the value (missing harmonics: 0). Throws std::invalid_argument for another number of rings.
  double operator()(const RingStack &load) const;

  /// Returns this functional of the load rotated counter-clockwise by @p angle [rad].
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
