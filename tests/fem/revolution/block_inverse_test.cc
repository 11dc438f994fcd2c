#include "fem/revolution/block_inverse.h"

#include <Eigen/SparseCholesky>
#include <gtest/gtest.h>

#include <omp.h>
#include <thread>
#include <vector>

using stemware::fem::BlockInverse;
using stemware::fem::LowerTriangle;
using stemware::fem::SingleThread;

namespace
{

/// Returns the lower triangle of the five-point Laplacian on n x n points, with @p shift added to the
/// diagonal. Its factors have much fill-in.
LowerTriangle membrane(int n, double shift)
{
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < n * n; ++i)
  {
    entries.emplace_back(i, i, 4 + shift);
    if ((i + 1) % n != 0)
      entries.emplace_back(i + 1, i, -1);
    if (i + n < n * n)
      entries.emplace_back(i + n, i, -1);
  }
  LowerTriangle result(n * n, n * n);
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

Eigen::VectorXd entries_of(const LowerTriangle &lower)
{
  return Eigen::Map<const Eigen::VectorXd>(lower.valuePtr(), lower.nonZeros());
}

Eigen::MatrixXd columns_of_inverse(const LowerTriangle &lower, const std::vector<unsigned int> &columns)
{
  Eigen::MatrixXd units = Eigen::MatrixXd::Zero(lower.rows(), static_cast<Eigen::Index>(columns.size()));
  for (std::size_t j = 0; j < columns.size(); ++j)
    units(columns[j], static_cast<Eigen::Index>(j)) = 1;
  return Eigen::SimplicialLLT<LowerTriangle>(lower).solve(units);
}

} // namespace

// The matrix is large enough for a factorisation by blocks, which calls a BLAS that is not thread-safe.
// Without a lock, about one run in ten would fail.
TEST(BlockInverse, IsThreadSafe)
{
  const unsigned int n = 110, n_threads = 8, n_rounds = 4, n_kept = 60;
  const LowerTriangle lower = membrane(n, 0.5);
  std::vector<unsigned int> kept;
  for (unsigned int i = 0; i < n_kept; ++i)
    kept.push_back(200 * i + 7);
  const BlockInverse inverse(lower, kept);
  const Eigen::VectorXd entries = entries_of(lower);
  const Eigen::MatrixXd whole = columns_of_inverse(lower, kept);
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

TEST(BlockInverse, RefusesMatricesThatAreNotPositiveDefinite)
{
  const LowerTriangle lower = membrane(10, -1);
  EXPECT_THROW(BlockInverse(lower, { 3, 50 })(entries_of(lower), 1), std::runtime_error);
}

TEST(SingleThread, RestoresTheThreadLimitsAfterTheLastGuard)
{
  const int before = omp_get_max_threads(), levels = omp_get_max_active_levels();
  {
    const SingleThread outer;
    std::thread([] { const SingleThread inner; }).join();
    EXPECT_EQ(omp_get_max_threads(), 1);
    EXPECT_EQ(omp_get_max_active_levels(), 0);
  }
  EXPECT_EQ(omp_get_max_threads(), before);
  EXPECT_EQ(omp_get_max_active_levels(), levels);
}
