#pragma once

#include <Eigen/Core>

#include <memory>
#include <vector>

namespace dealii
{
template <typename number>
class SparseMatrix;
}

namespace stemware::fem
{

/// Factors L L' of a sparse symmetric positive definite matrix (CHOLMOD, ordered by approximate minimum
/// degree).
///
/// Simplicial, that is without BLAS: harmonics are factorised by several threads at once, and Debian's serial
/// OpenBLAS gives wrong numbers to threads that enter it together.
class SparseCholesky
{
public:
  /// Reads the lower triangle of @p matrix. Throws std::runtime_error unless it is positive definite.
  explicit SparseCholesky(const dealii::SparseMatrix<double> &matrix);
  ~SparseCholesky();

  /// Solutions for the columns of @p right_hand_sides.
  Eigen::MatrixXd solve(const Eigen::MatrixXd &right_hand_sides) const;

private:
  struct Factors;
  std::unique_ptr<Factors> factors;
};

/// The part of the inverse of @p matrix in the rows @p kept and in the columns of the first @p n_columns of
/// them, shape [kept.size(), n_columns], without the rest of those columns: the kept rows are eliminated
/// last, so that the end of the triangular factor alone has the answer. Threads and exceptions as for
/// SparseCholesky.
Eigen::MatrixXd inverse_block(const dealii::SparseMatrix<double> &matrix,
                              const std::vector<unsigned int> &kept, unsigned int n_columns);

} // namespace stemware::fem
