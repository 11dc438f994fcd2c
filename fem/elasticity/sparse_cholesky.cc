#include "fem/elasticity/sparse_cholesky.h"

#include <deal.II/lac/sparse_matrix.h>

#include <Eigen/CholmodSupport>

#include <stdexcept>

namespace stemware::fem
{

namespace
{

using LowerTriangle = Eigen::SparseMatrix<double>;

LowerTriangle lower_triangle_of(const dealii::SparseMatrix<double> &matrix)
{
  // Rows of the symmetric matrix, begun at the diagonal, are the columns of its lower triangle.
  const auto n = static_cast<Eigen::Index>(matrix.m());
  LowerTriangle lower(n, n);
  lower.reserve(static_cast<Eigen::Index>(matrix.n_nonzero_elements() / 2 + matrix.m()));
  for (unsigned int column = 0; column < matrix.m(); ++column)
  {
    lower.startVec(column);
    // deal.II keeps the diagonal first, then the others in ascending order.
    for (auto entry = matrix.begin(column); entry != matrix.end(column); ++entry)
      if (entry->column() >= column)
        lower.insertBack(static_cast<Eigen::Index>(entry->column()), column) = entry->value();
  }
  lower.finalize();
  return lower;
}

} // namespace

struct SparseCholesky::Factors : Eigen::CholmodSimplicialLLT<LowerTriangle, Eigen::Lower>
{
  explicit Factors(const LowerTriangle &lower)
  {
    cholmod().nmethods = 1;
    cholmod().method[0].ordering = CHOLMOD_AMD;
    cholmod().postorder = 1;
    cholmod().print = 0; // what goes wrong is said by the caller
    compute(lower);
  }
};

SparseCholesky::SparseCholesky(const dealii::SparseMatrix<double> &matrix)
    : factors(std::make_unique<Factors>(lower_triangle_of(matrix)))
{
  if (factors->info() != Eigen::Success)
    throw std::runtime_error("A stiffness matrix is not positive definite: the mesh is distorted, or nothing "
                             "holds the body.");
}

SparseCholesky::~SparseCholesky() = default;

Eigen::MatrixXd SparseCholesky::solve(const Eigen::MatrixXd &right_hand_sides) const
{
  return factors->solve(right_hand_sides);
}

} // namespace stemware::fem
