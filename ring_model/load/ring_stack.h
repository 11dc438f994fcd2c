#pragma once

#include <Eigen/Core>

#include <map>
#include <vector>

namespace stemware::ring
{
/// Normal load on the table as a sum of J concentric rings at radii r_j. Each ring has the line load
///
///   lambda_j(theta) = a_{j,0} + sum_{n>=1} (a_{j,n} cos n theta + b_{j,n} sin n theta)   [N/rad],
///
/// with theta from the direction of sliding, counter-clockwise seen from above (slip frame: x along the
/// motion, y to its left, z up). Their sum lambda(theta) is the load of the whole contact; "the load", a_n,
/// b_n and values at theta refer to the sum. One ring's load may be negative; a negative sum is tensile.
///
///     const RingStack load({ a_0, a_1 }, { 0, b_1 }, radius);   // [N/rad], [m]
///     load.normal_force();                                      // 2 pi a_0 [N]
///     load.moment_ratio(radius);                                // |M_N| / (N R / 2)
///
/// A load that depends on the spin is a function that returns a RingStack.
class RingStack
{
public:
  /// Ring of a stack.
  struct Ring
  {
    double radius;         ///< r_j > 0 [m]
    std::vector<double> a; ///< a_{j,0}...a_{j,n_max} [N/rad]
    std::vector<double> b; ///< as many; b_{j,0} = 0
  };

  /// @p rings: at least one, all with equally many coefficients; the sum of the a_{j,0} is N / 2 pi > 0.
  /// Throws std::invalid_argument naming the inadmissible value.
  explicit RingStack(std::vector<Ring> rings);

  /// Creates one ring: a_0...a_{n_max}, b_0 = 0...b_{n_max} [N/rad] at @p radius R > 0 [m]. Throws likewise.
  RingStack(std::vector<double> a, std::vector<double> b, double radius);

  /// Returns one ring of normal force N [N] and @p moment M_N [N m]: b_1 = M_{N,x} / (pi R), a_1 = -M_{N,y} /
  /// (pi R). Tensile at some azimuths if |M_N| > N R / 2. Throws std::invalid_argument unless all is finite
  /// and N, R > 0.
  static RingStack first_harmonic(double normal_force, const Eigen::Vector2d &moment, double radius);

  /// Returns the individual rings.
  const std::vector<Ring> &rings() const { return stack; }
  /// Returns the radii r_j of the rings [m].
  std::vector<double> radii() const;

  /// Returns the highest harmonic n_max.
  unsigned int n_harmonics() const { return static_cast<unsigned int>(cosine.size()) - 1; }

  /// Returns a_n [N/rad]; zero beyond n_harmonics().
  double a(unsigned int n) const { return n < cosine.size() ? cosine[n] : 0.; }

  /// Returns b_n [N/rad]; zero beyond n_harmonics().
  double b(unsigned int n) const { return n < sine.size() ? sine[n] : 0.; }

  /// Returns the radius [m] of the single ring with the same N, M_N and first harmonic: |M_N| / (pi
  /// sqrt(a_1^2 + b_1^2)), R for one ring, the mean weighted with |a_{j,0}| without a moment (below 1e-9 N
  /// R).
  double radius() const;

  /// Returns N = 2 pi a_0 [N].
  double normal_force() const;

  /// Returns M_N = (sum y f, -sum x f) = sum_j pi r_j (b_{j,1}, -a_{j,1}) [N m], about the rings' centre.
  Eigen::Vector2d moment() const;

  /// Returns m = |M_N| / (N R / 2) with R = @p contact_radius > 0 [m]. A single ring of this radius under a
  /// first harmonic lifts off at m = 1, and tips at m = 2.
  double moment_ratio(double contact_radius) const;

  /// Returns lambda(theta) [N/rad], theta in rad.
  double operator()(double theta) const;

  /// Returns d lambda / d theta [N/rad^2].
  double derivative(double theta) const;

  /// Returns the minimum of lambda [N/rad]: minima among 32 samples per shortest wave, polished to rounding.
  double minimum() const;

  /// Returns the tension that the table would have to exert, int max(0, -lambda) dtheta [N], to rounding.
  double pulling_force() const;

  /// Returns the load truncated to the harmonics up to @p n_max.
  RingStack truncated(unsigned int n_max) const;

  /// Returns the load rotated counter-clockwise by @p angle [rad]: lambda'(theta) = lambda(theta - angle).
  RingStack rotated(double angle) const;

  /// Returns the largest relative difference to @p other: of the sum's a_n and b_n, over a_0 of @p other, and
  /// of radius(), over the radius of @p other.
  double difference(const RingStack &other) const;

private:
  /// Returns lambda at 32 n_max angles, evenly spaced from 0 [N/rad].
  std::vector<double> evenly_spaced_values() const;

  /// Returns the local minima of lambda by angle, polished to rounding, and the samples next to them. Angles
  /// may lie slightly outside [0, 2 pi).
  std::map<double, double> local_minima() const;

  /// Returns the integral of lambda from one angle to another [N].
  double integral(double from, double to) const;

  std::vector<Ring> stack;
  std::vector<double> cosine; ///< a_n of the sum
  std::vector<double> sine;   ///< b_n of the sum
};
} // namespace stemware::ring
