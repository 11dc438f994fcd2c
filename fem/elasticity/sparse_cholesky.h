#pragma once

#include <Eigen/Core>

#include <memory>

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

} // namespace stemware::fem
