// The factorisation of sparse matrices against a matrix whose inverse is known, also from several threads at
// once.
#include "fem/factorisation/sparse_cholesky.h"

#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparse_matrix.h>

#include <gtest/gtest.h>

#include <thread>
#include <vector>

using stemware::fem::BlockInverse;
using stemware::fem::lower_triangle_of;
using stemware::fem::LowerTriangle;
using stemware::fem::SparseCholesky;

namespace
{

/// Five-point Laplacian on n x n points inside a square, @p shift added to its diagonal: dense factors.
struct Membrane
{
  Membrane(unsigned int n, double shift)
  {
    dealii::DynamicSparsityPattern dynamic(n * n);
    for (unsigned int i = 0; i < n * n; ++i)
      for (unsigned int j : neighbours(i, n))
        dynamic.add(i, j);
    for (unsigned int i = 0; i < n * n; ++i)
      dynamic.add(i, i);
    pattern.copy_from(dynamic);
    matrix.reinit(pattern);
    for (unsigned int i = 0; i < n * n; ++i)
    {
      matrix.set(i, i, 4 + shift);
      for (unsigned int j : neighbours(i, n))
        matrix.set(i, j, -1);
    }
  }

  static std::vector<unsigned int> neighbours(unsigned int i, unsigned int n)
  {
    std::vector<unsigned int> result;
    if (i % n > 0)
      result.push_back(i - 1);
    if (i % n + 1 < n)
      result.push_back(i + 1);
    if (i >= n)
      result.push_back(i - n);
    if (i + n < n * n)
      result.push_back(i + n);
    return result;
  }

  dealii::SparsityPattern pattern;
  dealii::SparseMatrix<double> matrix;
};

/// Modes sin(pi p x) sin(pi q y) of the membrane, one column each for p = q = 1 ... n_modes.
Eigen::MatrixXd modes(unsigned int n, unsigned int n_modes)
{
  Eigen::MatrixXd result(n * n, n_modes);
  for (unsigned int p = 1; p <= n_modes; ++p)
    for (unsigned int i = 0; i < n * n; ++i)
      result(i, p - 1) =
        std::sin(M_PI * p * (i % n + 1) / (n + 1)) * std::sin(M_PI * p * (i / n + 1) / (n + 1));
  return result;
}

Eigen::VectorXd entries_of(const LowerTriangle &lower)
{
  return Eigen::Map<const Eigen::VectorXd>(lower.valuePtr(), lower.nonZeros());
}

double eigenvalue(unsigned int p, unsigned int n)
{
  return 8 * std::pow(std::sin(M_PI * p / (2 * (n + 1))), 2);
}

} // namespace

TEST(SparseCholesky, SolvesForTheModesOfAMembrane)
{
  const unsigned int n = 40;
  const Membrane membrane(n, 0.5);
  const Eigen::MatrixXd forces = modes(n, 7);
  const Eigen::MatrixXd solution = SparseCholesky(membrane.matrix).solve(forces);
  for (unsigned int p = 1; p <= 7; ++p)
    EXPECT_LT((solution.col(p - 1) * (eigenvalue(p, n) + 0.5) - forces.col(p - 1)).cwiseAbs().maxCoeff(),
              1e-12)
      << "p = " << p;
}

// The second matrix has the order of elimination of the first.
TEST(SparseCholesky, BlocksSolveForTheModesOfAMembrane)
{
  const unsigned int n = 60;
  const Eigen::MatrixXd forces = modes(n, 3);
  BlockCholesky factors(lower_triangle_of(Membrane(n, 0.5).matrix));
  for (const double shift : { 0.5, 2. })
  {
    factors.factorise(lower_triangle_of(Membrane(n, shift).matrix));
    for (unsigned int p = 1; p <= 3; ++p)
      EXPECT_LT((factors.solve(forces.col(p - 1)) * (eigenvalue(p, n) + shift) - forces.col(p - 1))
                  .cwiseAbs()
                  .maxCoeff(),
                1e-12)
        << "p = " << p << ", shift " << shift;
  }
  EXPECT_THROW(factors.factorise(lower_triangle_of(Membrane(n, -10).matrix)), std::runtime_error);
}

TEST(SparseCholesky, PartOfTheInverseIsThatOfTheWhole)
{
  const unsigned int n = 30;
  const Membrane membrane(n, 0.5);
  const std::vector<unsigned int> kept = { 3, 899, 411, 0, 412, 77 };
  const unsigned int n_columns = 4;
  Eigen::MatrixXd units = Eigen::MatrixXd::Zero(n * n, n_columns);
  for (unsigned int j = 0; j < n_columns; ++j)
    units(kept[j], j) = 1;
  const Eigen::MatrixXd whole = SparseCholesky(membrane.matrix).solve(units);
  const LowerTriangle lower = lower_triangle_of(membrane.matrix);
  const Eigen::MatrixXd part = BlockInverse(lower, kept)(entries_of(lower), n_columns);
  ASSERT_EQ(part.rows(), static_cast<Eigen::Index>(kept.size()));
  for (unsigned int j = 0; j < n_columns; ++j)
    for (std::size_t i = 0; i < kept.size(); ++i)
      EXPECT_NEAR(part(static_cast<Eigen::Index>(i), j), whole(kept[i], j), 1e-14);
}

// Large enough to be factorised by blocks, with a BLAS that threads must not enter together: without its lock
// one in some ten runs of this test fails.
TEST(BlockInverse, ServesThreadsTogether)
{
  const unsigned int n = 110, n_threads = 8, n_rounds = 4, n_kept = 60;
  const Membrane membrane(n, 0.5);
  std::vector<unsigned int> kept;
  for (unsigned int i = 0; i < n_kept; ++i)
    kept.push_back(200 * i + 7);
  const LowerTriangle lower = lower_triangle_of(membrane.matrix);
  const BlockInverse inverse(lower, kept);
  const Eigen::VectorXd entries = entries_of(lower);
  Eigen::MatrixXd units = Eigen::MatrixXd::Zero(n * n, n_kept);
  for (unsigned int j = 0; j < n_kept; ++j)
    units(kept[j], j) = 1;
  const Eigen::MatrixXd whole = SparseCholesky(membrane.matrix).solve(units);
  std::vector<double> errors(n_threads, 0.);
  std::vector<std::thread> threads;
  for (unsigned int t = 0; t < n_threads; ++t)
    threads.emplace_back(
      [&, t]
      {
        for (unsigned int round = 0; round < n_rounds; ++round)
        {
          const Eigen::MatrixXd part = inverse(entries, n_kept);
          for (unsigned int i = 0; i < n_kept; ++i)
            errors[t] = std::max(errors[t], (part.row(i) - whole.row(kept[i])).cwiseAbs().maxCoeff());
        }
      });
  for (std::thread &thread : threads)
    thread.join();
  for (const double error : errors)
    EXPECT_LT(error, 1e-13);
}

TEST(SparseCholesky, RefusesWhatIsNotPositiveDefinite)
{
  const Membrane membrane(10, -1);
  EXPECT_THROW(SparseCholesky{ membrane.matrix }, std::runtime_error);
  const LowerTriangle lower = lower_triangle_of(membrane.matrix);
  EXPECT_THROW(BlockInverse(lower, { 3, 50 })(entries_of(lower), 1), std::runtime_error);
}
