// Several lines at a time against Eigen's elimination with pivots of one.
#include "fem/revolution/line_bundle.h"

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace stemware::fem
{
namespace
{

constexpr Eigen::Index band = 2, n_shapes = 4;

/// The compliance of a line contact at n places: the logarithm of their distance, bounded.
RowMatrix compliance(Eigen::Index n)
{
  RowMatrix matrix(n, n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index k = 0; k < n; ++k)
      matrix(i, k) =
        std::log(1 + 3. * static_cast<double>(n)) - std::log(1 + 3 * std::abs(static_cast<double>(i - k)));
  return matrix;
}

/// T of a pressure whose stiffness differs from line to line and from place to place, one line without any.
double tangent(Eigen::Index i, Eigen::Index k, int lane)
{
  const double stiffness = lane * std::pow(10., lane) / (1 + static_cast<double>(i + k));
  const double of_distance[] = { 8, 2, -1 }; // as of the middle nodes of quadratic elements
  return stiffness * of_distance[std::abs(i - k)];
}

double slide(Eigen::Index i, int lane)
{
  return std::cos(lane + 0.1 * static_cast<double>(i));
}

double shape(Eigen::Index i, Eigen::Index column, int lane)
{
  return std::sin(static_cast<double>(i * (column + 1)) + lane);
}

class LineBundles : public testing::TestWithParam<int>
{
};

TEST_P(LineBundles, AreTheSystemsOfTheirLines)
{
  const Eigen::Index n = GetParam();
  const RowMatrix normal = compliance(n), radial = -0.2 * compliance(n);
  LineBundle bundle;
  for (int round = 0; round < 2; ++round) // what was before does not count
  {
    bundle.reset(n, band, n_shapes + 1);
    for (int lane = 0; lane < Lanes::n; ++lane)
      for (Eigen::Index i = 0; i < n; ++i)
      {
        for (Eigen::Index k = std::max<Eigen::Index>(0, i - band); k <= std::min(n - 1, i + band); ++k)
          bundle.tangent(i, k, lane) = tangent(i, k, lane);
        bundle.slide(i, lane) = slide(i, lane);
        for (Eigen::Index c = 0; c < n_shapes; ++c)
          bundle.shape(i, c, lane) = shape(i, c, lane);
        bundle.unbalanced(i, lane) = 1. / static_cast<double>(1 + i + lane);
      }
    const LaneTable solution = bundle.solve(normal, radial);
    for (int lane = 0; lane < Lanes::n; ++lane)
    {
      Eigen::MatrixXd t = Eigen::MatrixXd::Zero(n, n), rhs(n, n_shapes + 1);
      Eigen::VectorXd slides(n);
      for (Eigen::Index i = 0; i < n; ++i)
      {
        for (Eigen::Index k = std::max<Eigen::Index>(0, i - band); k <= std::min(n - 1, i + band); ++k)
          t(i, k) = tangent(i, k, lane);
        slides(i) = slide(i, lane);
        for (Eigen::Index c = 0; c < n_shapes; ++c)
          rhs(i, c) = shape(i, c, lane);
        rhs(i, n_shapes) = 1. / static_cast<double>(1 + i + lane);
      }
      rhs.leftCols(n_shapes) = (t * rhs.leftCols(n_shapes)).eval();
      const Eigen::MatrixXd d = normal + radial * slides.asDiagonal();
      const Eigen::MatrixXd x = (Eigen::MatrixXd::Identity(n, n) + t * d).fullPivLu().solve(rhs);
      for (Eigen::Index c = 0; c <= n_shapes; ++c)
        for (Eigen::Index i = 0; i < n; ++i)
          EXPECT_NEAR(solution(i, c, lane), x(i, c), 1e-9 * x.col(c).cwiseAbs().maxCoeff())
            << "line " << lane << ", place " << i << ", column " << c;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Widths, LineBundles, testing::Values(1, 2, 3, 4, 5, 31));

TEST(LaneTable, SumsProductsLaneByLane)
{
  LaneTable one(3, 2), other(3, 4);
  for (int lane = 0; lane < Lanes::n; ++lane)
    for (Eigen::Index i = 0; i < 3; ++i)
    {
      for (Eigen::Index a = 0; a < 2; ++a)
        one(i, a, lane) = shape(i, a, lane);
      for (Eigen::Index c = 0; c < 4; ++c)
        other(i, c, lane) = slide(i + c, lane);
    }
  const LaneTable sums = products(one, other);
  for (int lane = 0; lane < Lanes::n; ++lane)
    for (Eigen::Index a = 0; a < 2; ++a)
      for (Eigen::Index c = 0; c < 4; ++c)
      {
        double sum = 0;
        for (Eigen::Index i = 0; i < 3; ++i)
          sum += shape(i, a, lane) * slide(i + c, lane);
        EXPECT_NEAR(sums(a, c, lane), sum, 1e-14);
      }
}

} // namespace
} // namespace stemware::fem
