#pragma once

#include <boost/container/small_vector.hpp>

namespace stemware::ring
{
/// Friction kernels of a sliding and spinning ring for one slip ratio and n = 0...n_max:
///
///   P_n(eps) = int_0^{2 pi} sqrt(1 + eps^2 - 2 eps cos psi) cos(n psi) dpsi,
///   K_n(eps) = -P_n'(eps)               (torque),
///   U_n(eps) = P_n(eps) - eps P_n'(eps) (drag).
///
/// eps = omega R / v is the rim speed over the sliding speed, any real number including |eps| = 1 and
/// infinity (v = 0). All three are dimensionless. All sums have positive terms, which keeps relative
/// precision except next to the zeros of K_n and U_n at |eps| = 1. Derivation: docs/theory/kernels.md.
///
///     const FrictionKernels kernels(omega * radius, v, load.n_harmonics()); // [m/s]
///     kernels.K(1);                                                        // torque of the first harmonic
class FrictionKernels
{
public:
  /// Computes the kernels at eps = rim_speed / speed up to the harmonic @p n_max. @p rim_speed: omega R
  /// [m/s], positive for a counter-clockwise spin. @p speed: sliding speed v >= 0 of the ring's centre [m/s].
  /// Throws std::invalid_argument if a speed is not finite, v < 0, or both are zero (no slip direction).
  FrictionKernels(double rim_speed, double speed, unsigned int n_max);

  /// Returns the highest computed harmonic.
  unsigned int n_max() const { return highest; }

  /// Returns P_n(eps), n <= n_max. P_0 is infinite at v = 0.
  double P(unsigned int n) const { return values[3 * n]; }

  /// Returns K_n(eps), n <= n_max.
  double K(unsigned int n) const { return values[3 * n + 1]; }

  /// Returns U_n(eps), n <= n_max.
  double U(unsigned int n) const { return values[3 * n + 2]; }

private:
  /// Fills `values` for 0 <= eps <= 1. @p complement: 1 - eps^2 without cancellation. @p divided: with P_n /
  /// eps, finite at eps = 0, instead of P_n for n >= 1.
  void evaluate_slow_spin(double eps, double complement, bool divided);

  unsigned int highest;
  boost::container::small_vector<double, 3 * 34> values; ///< P_n, K_n, U_n for n = 0...n_max
};
} // namespace stemware::ring
