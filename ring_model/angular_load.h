#pragma once

#include <Eigen/Core>

#include <map>
#include <vector>

namespace stemware::ring
{
/**
 * The normal load around a contact ring,
 *
 *   lambda(theta) = a_0 + sum_{n>=1} (a_n cos n theta + b_n sin n theta)   [N/rad],
 *
 * with theta from the direction of sliding, counter-clockwise seen from above (slip frame: x along the
 * motion, y to its left, z up). It is the plain value that a contact calculation hands to the ring: no
 * history, no units other than SI.
 */
class AngularLoad
{
public:
  /**
   * @param a      Cosine coefficients a_0...a_{n_max} [N/rad]; a_0 = N / 2 pi > 0.
   * @param b      Sine coefficients, as many as @p a [N/rad]; b_0 = 0.
   * @param radius Ring radius R > 0 [m].
   * @throws std::invalid_argument naming the value that is not allowed.
   */
  AngularLoad(std::vector<double> a, std::vector<double> b, double radius);

  /**
   * The first harmonic that carries @p normal_force N [N] with the moment @p moment = M_N [N m]:
   * b_1 = M_{N,x} / (pi R), a_1 = -M_{N,y} / (pi R). Formal: it turns negative where |M_N| > N R / 2.
   * @throws std::invalid_argument if a value is not finite or N, R are not positive.
   */
  static AngularLoad first_harmonic(double normal_force, const Eigen::Vector2d &moment, double radius);

  /// Highest harmonic n_max.
  unsigned int n_harmonics() const { return static_cast<unsigned int>(cosine.size()) - 1; }

  /// a_n [N/rad]; zero beyond n_harmonics().
  double a(unsigned int n) const { return n < cosine.size() ? cosine[n] : 0.; }

  /// b_n [N/rad]; zero beyond n_harmonics().
  double b(unsigned int n) const { return n < sine.size() ? sine[n] : 0.; }

  /// Ring radius R [m].
  double radius() const { return ring_radius; }

  /// N = 2 pi a_0 [N].
  double normal_force() const;

  /// M_N = (sum y f, -sum x f) = (pi R b_1, -pi R a_1) [N m], about the ring's centre.
  Eigen::Vector2d moment() const;

  /// m = |M_N| / (N R / 2) = sqrt(a_1^2 + b_1^2) / a_0. A ring that cannot pull tips at m = 2.
  double moment_ratio() const;

  /// lambda(theta) [N/rad], theta in rad.
  double operator()(double theta) const;

  /// d lambda / d theta [N/rad^2].
  double derivative(double theta) const;

  /**
   * The least value of lambda over all theta [N/rad]. Every local minimum found among 32 samples per wave
   * length of the highest harmonic is polished to rounding.
   */
  double minimum() const;

  /**
   * What the table would have to pull with, int max(0, -lambda) dtheta [N]: 0 unless minimum() is negative.
   * Between the changes of sign, found as the minimum is, the integral is exact.
   */
  double pulling_force() const;

  /// The load without the harmonics above @p n_max.
  AngularLoad truncated(unsigned int n_max) const;

  /// The same load turned counter-clockwise by @p angle [rad]: lambda'(theta) = lambda(theta - angle).
  AngularLoad rotated(double angle) const;

  /// The mirror image in the direction of motion, lambda'(theta) = lambda(-theta): all b_n change sign.
  AngularLoad mirrored() const;

private:
  /// lambda at 32 n_max angles, evenly spaced from 0 [N/rad].
  std::vector<double> evenly_spaced_values() const;

  /// Local minima by their angle, polished to rounding, and the samples next to them; an angle may be a
  /// little outside [0, 2 pi).
  std::map<double, double> local_minima() const;

  /// Integral of lambda from one angle to another [N].
  double integral(double from, double to) const;

  std::vector<double> cosine;
  std::vector<double> sine;
  double ring_radius;
};
} // namespace stemware::ring
