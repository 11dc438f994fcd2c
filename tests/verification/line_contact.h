#pragma once

// Hard contact of a rigid crowned ring with a half-space, as a line contact whose width depends on the load:
// leading order in width / radius, all harmonics that the lines resolve.
#include "ring_model/load/constants.h"
#include "tests/verification/half_space_formulas.h"

#include <Eigen/Dense>

#include <stdexcept>
#include <vector>

namespace stemware::verification
{

/// Returns the displacement at the middle of a line load cos(n theta) with Hertz half-width b around a ring,
/// in units of line load / (pi E*), minus 2 ln(16 R / b) + 1. For n b << R it is -4 sum_{k <= n} 1 / (2k -
/// 1); the second term is the difference between 2 int p K_0(n |x| / R) dx of a straight line and its
/// logarithm. @p slenderness: b / R.
inline double half_space_eigenvalue(unsigned int n, double slenderness)
{
  double sum = 0;
  for (unsigned int k = 1; k <= n; ++k)
    sum += 1 / (2. * k - 1);
  if (n == 0)
    return 0;
  const double z = n * slenderness, euler = 0.57721566490153286;
  const auto beyond_logarithm = [&](double angle)
  {
    const double distance = z * std::sin(angle);
    return 4 / ring::pi * std::pow(std::cos(angle), 2) *
           (boost::math::cyl_bessel_k(0, distance) + std::log(distance / 2) + euler);
  };
  return -4 * sum + 2 * integral(beyond_logarithm, 0, ring::pi / 2, 4);
}

/// Solves x (L - ln x) + S[x] = w_0 + w_1 cos(theta) for the relative line load x = q / mean q > 0, with
/// L = 2 ln(16 R / b_0) + 1 and the eigenvalues S of the harmonics, by Newton's method on the loaded lines.
class LineContact
{
public:
  LineContact(double moment_ratio, unsigned int n_lines, double slenderness)
      : n_lines(n_lines)
      , self_influence(2 * std::log(16 / slenderness) + 1)
      , influence(n_lines, n_lines)
      , load(n_lines)
  {
    std::vector<double> by_distance(n_lines, 0.);
    for (unsigned int n = 0; n <= n_lines / 2; ++n)
    {
      const double value =
        half_space_eigenvalue(n, slenderness) * (n == 0 || 2 * n == n_lines ? 1 : 2) / n_lines;
      for (unsigned int i = 0; i < n_lines; ++i)
        by_distance[i] += value * std::cos(n * azimuth(i));
    }
    for (unsigned int i = 0; i < n_lines; ++i)
    {
      load(i) = std::max(1 + moment_ratio * std::cos(azimuth(i)), 0.02);
      for (unsigned int j = 0; j < n_lines; ++j)
        influence(i, j) = by_distance[(i + n_lines - j) % n_lines];
    }
    solve(moment_ratio);
  }

  /// Returns a_n / a_0.
  double harmonic(unsigned int n) const
  {
    double sum = 0;
    for (unsigned int i = 0; i < n_lines; ++i)
      sum += 2 * load(i) * std::cos(n * azimuth(i)) / n_lines;
    return sum;
  }

  double loaded_share() const { return static_cast<double>((load.array() > 0).count()) / n_lines; }

private:
  double azimuth(unsigned int line) const { return 2 * ring::pi * line / n_lines; }

  void solve(double moment_ratio)
  {
    Eigen::Vector2d motion(self_influence, 0);
    for (unsigned int step = 0; step < 100; ++step)
    {
      std::vector<int> lines;
      for (unsigned int i = 0; i < n_lines; ++i)
        if (load(i) > 0)
          lines.push_back(static_cast<int>(i));
      const Eigen::Index n = static_cast<Eigen::Index>(lines.size());
      const Eigen::VectorXd x = load(lines);
      Eigen::MatrixX2d motions(n, 2);
      for (Eigen::Index i = 0; i < n; ++i)
        motions.row(i) << 1, std::cos(azimuth(static_cast<unsigned int>(lines[static_cast<std::size_t>(i)])));
      Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n + 2, n + 2);
      matrix.topLeftCorner(n, n) = influence(lines, lines);
      matrix.diagonal().head(n).array() += self_influence - x.array().log() - 1;
      matrix.topRightCorner(n, 2) = -motions;
      matrix.bottomLeftCorner(2, n) = motions.transpose() / n_lines;
      Eigen::VectorXd residual(n + 2);
      residual << influence(lines, lines) * x +
                    x.cwiseProduct(Eigen::VectorXd(self_influence - x.array().log())) - motions * motion,
        motions.transpose() * x / n_lines - Eigen::Vector2d(1, moment_ratio / 2);
      const Eigen::VectorXd correction = -matrix.partialPivLu().solve(residual);
      load(lines) = (x + correction.head(n)).cwiseMax(0.);
      motion += correction.tail<2>();
      if (correction.norm() < 1e-12 * std::sqrt(n_lines))
        return;
    }
    throw std::runtime_error("no line contact");
  }

  const unsigned int n_lines;
  const double self_influence; ///< L
  Eigen::MatrixXd influence;
  Eigen::VectorXd load;
};

} // namespace stemware::verification
