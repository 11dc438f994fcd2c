// Dense elimination against Eigen's with full pivots, products against Eigen's.
#include "fem/revolution/dense_algebra.h"

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <cmath>

namespace stemware::fem
{
namespace
{

class DenseSystems : public testing::TestWithParam<int>
{
};

/// Numbers without order or symmetry; the first pivots are small, so that rows have to change their places.
RowMatrix numbers(Eigen::Index n, Eigen::Index width)
{
  RowMatrix matrix(n, width);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index k = 0; k < width; ++k)
      matrix(i, k) = std::sin(1.7 * static_cast<double>(i * width + k) + 0.3) + (i + k == n - 1 ? 4 : 0);
  return matrix;
}

TEST_P(DenseSystems, HaveTheSolutionsOfFullPivots)
{
  const Eigen::Index n = GetParam(), n_columns = 4;
  RowMatrix system = numbers(n, n + n_columns);
  const Eigen::MatrixXd expected =
    Eigen::MatrixXd(system.leftCols(n)).fullPivLu().solve(Eigen::MatrixXd(system.rightCols(n_columns)));
  solve_dense(system, n_columns);
  EXPECT_LT((system.rightCols(n_columns) - expected).norm(), 1e-11 * expected.norm());
}

// Below, at and beyond the number of pivots that are taken together.
INSTANTIATE_TEST_SUITE_P(OfSize, DenseSystems, testing::Values(1, 3, 8, 9, 16, 61));

TEST(DenseSystem, ThatIsSingularHasNoFiniteSolution)
{
  RowMatrix system = numbers(9, 10);
  system.row(4).head(9) = system.row(7).head(9);
  solve_dense(system, 1);
  EXPECT_FALSE(system.rightCols(1).allFinite() && system.rightCols(1).norm() < 1e10);
}

TEST(DenseProduct, IsAddedAsEigenDoes)
{
  const Eigen::MatrixXd a = numbers(21, 40), b = numbers(30, 7);
  const auto part = a.middleCols(3, 30);
  Eigen::MatrixXd sum = numbers(21, 7);
  const Eigen::MatrixXd expected = sum + part * b;
  add_product(part, b, sum);
  EXPECT_LT((sum - expected).norm(), 1e-14 * expected.norm());
}

} // namespace
} // namespace stemware::fem
