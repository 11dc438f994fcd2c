#pragma once

#include <Eigen/SparseCore>

#include <memory>
#include <vector>

namespace dealii
{
template <typename number>
class SparseMatrix;
}

namespace stemware::fem
{

/// Lower triangle of a symmetric matrix, column by column.
using LowerTriangle = Eigen::SparseMatrix<double>;

/// Returns the lower triangle of the symmetric @p matrix.
LowerTriangle lower_triangle_of(const dealii::SparseMatrix<double> &matrix);

/// Limits OpenMP in this thread and OpenBLAS in the process to one thread during its lifetime, so that
/// results do not depend on numbers of threads. Objects may overlap: the first sets OpenBLAS's count, the
/// last restores it.
class SingleThread
{
public:
  SingleThread();
  ~SingleThread();
  SingleThread(const SingleThread &) = delete;
  SingleThread &operator=(const SingleThread &) = delete;

private:
  const int omp_threads, omp_levels; ///< to be restored
};

/// Selected rows and columns of the inverses of symmetric positive definite matrices of equal pattern. The
/// selected rows are eliminated last, so that only the end of the factor is needed. Thread-safe; large
/// matrices are factorised by blocks (BLAS), one after the other.
class BlockInverse
{
public:
  /// Prepares inverses of matrices with the lower triangle @p pattern, in the rows and columns @p kept.
  BlockInverse(const LowerTriangle &pattern, const std::vector<unsigned int> &kept);
  ~BlockInverse();

  /// Returns the inverse in the kept rows and the first @p n_columns kept columns, shape [kept.size(),
  /// n_columns], of the matrix with @p entries. Throws std::runtime_error unless positive definite.
  Eigen::MatrixXd operator()(const Eigen::VectorXd &entries, unsigned int n_columns) const;

private:
  struct Plan;
  std::unique_ptr<Plan> plan;
};

} // namespace stemware::fem
