#pragma once

// Rigid square plate on a Winkler mat with lift-off, tilted in any direction; exact up to rounding.
#include <Eigen/Dense>
#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

namespace stemware::verification
{

/// Square plate [-1, 1]^2 [m] on a mat of 1 N/m^3 with the penetration max(0, motion . (1, x, y)), under a
/// force of 1 N at the point `centre`.
class LiftedSquare
{
public:
  /// Solves the balance by Newton's method; the force moves from the middle to @p centre in steps.
  explicit LiftedSquare(const Eigen::Vector2d &centre)
  {
    const Eigen::Vector3d demand(1, centre(0), centre(1));
    constexpr unsigned int n_steps = 40;
    for (unsigned int step = 1; step <= 2 * n_steps; ++step)
    {
      const double share = std::min(1., static_cast<double>(step) / n_steps);
      const Eigen::Vector3d wanted(1, share * demand(1), share * demand(2));
      const Eigen::Matrix3d stiffness = moments();
      motion += stiffness.ldlt().solve(wanted - stiffness * motion);
    }
  }

  /// Coefficients of the penetration for (1, x, y) [m].
  Eigen::Vector3d motion = { 0.25, 0, 0 };

  double share() const
  {
    return integral([](const Eigen::Vector3d &) { return 1.; }) / 4;
  }

  double peak() const { return motion(0) + std::abs(motion(1)) + std::abs(motion(2)); }

  /// Returns a_n / a_0 or, for @p of_sine, b_n / a_0 of the load about the origin, n > 0.
  double harmonic(unsigned int n, bool of_sine) const
  {
    return 2 * integral(
                 [&](const Eigen::Vector3d &at)
                 {
                   const double angle = n * std::atan2(at(2), at(1));
                   return motion.dot(at) * (of_sine ? std::sin(angle) : std::cos(angle));
                 });
  }

private:
  std::vector<Eigen::Vector3d> loaded() const
  {
    const std::vector<Eigen::Vector3d> square = { { 1, -1, -1 }, { 1, 1, -1 }, { 1, 1, 1 }, { 1, -1, 1 } };
    std::vector<Eigen::Vector3d> corners;
    for (std::size_t i = 0; i < 4; ++i)
    {
      const Eigen::Vector3d &here = square[i], &next = square[(i + 1) % 4];
      const double depth = motion.dot(here), next_depth = motion.dot(next);
      if (depth > 0)
        corners.push_back(here);
      if ((depth > 0) != (next_depth > 0))
        corners.push_back(here + depth / (depth - next_depth) * (next - here));
    }
    return corners;
  }

  /// Returns int @p of(1, x, y) over the loaded part, by signed triangles between the origin and the edges.
  /// Along a ray the integrand is a polynomial of degree 2 times a function of the azimuth.
  double integral(const std::function<double(const Eigen::Vector3d &)> &of) const
  {
    using Gauss = boost::math::quadrature::gauss<double, 30>;
    using Few = boost::math::quadrature::gauss<double, 7>;
    const std::vector<Eigen::Vector3d> corners = loaded();
    constexpr unsigned int n_parts = 60; // enough for an edge close to the origin
    double sum = 0;
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
      const Eigen::Vector3d &begin = corners[i], &end = corners[(i + 1) % corners.size()];
      const double cross = begin(1) * end(2) - begin(2) * end(1);
      const auto ray = [&](double t)
      {
        const Eigen::Vector3d edge = begin + t * (end - begin);
        return Few::integrate([&](double s) { return s * of(Eigen::Vector3d(1, s * edge(1), s * edge(2))); },
                              0., 1.);
      };
      for (unsigned int part = 0; part < n_parts; ++part)
        sum += cross * Gauss::integrate(ray, double(part) / n_parts, (part + 1.) / n_parts);
    }
    return sum;
  }

  Eigen::Matrix3d moments() const
  {
    Eigen::Matrix3d matrix;
    for (Eigen::Index i = 0; i < 3; ++i)
      for (Eigen::Index j = 0; j <= i; ++j)
        matrix(i, j) = matrix(j, i) = integral([&](const Eigen::Vector3d &at) { return at(i) * at(j); });
    return matrix;
  }
};

} // namespace stemware::verification
