#include "fem/elasticity/sparse_cholesky.h"

#include <deal.II/lac/sparse_matrix.h>

#include <Eigen/CholmodSupport>
#include <Eigen/Dense>

#include <omp.h>
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

[[noreturn]] void throw_indefinite()
{
  throw std::runtime_error(
    "A stiffness matrix is not positive definite: the mesh is distorted, or nothing holds "
    "the body.");
}

/// Factors L L' by CHOLMOD, in the order of elimination given or found.
class OrderedFactors
{
public:
  /// Eliminates the rows @p kept last, each part in an order of little fill-in.
  OrderedFactors(LowerTriangle lower, const std::vector<unsigned int> &kept)
  {
    omp_set_max_active_levels(0); // CHOLMOD starts four threads of its own for each of the caller's
    cholmod_start(&common);
    common.print = 0;
    common.nmethods = 1;
    common.method[0].ordering = CHOLMOD_GIVEN;
    common.postorder = 0;
    common.supernodal = CHOLMOD_AUTO;
    common.final_asis = 0;
    common.final_super = 0;
    common.final_ll = 1;
    cholmod_sparse view = Eigen::viewAsCholmod(Eigen::Ref<LowerTriangle>(lower));
    view.stype = -1;
    std::vector<int> part(view.nrow, 0);
    for (const unsigned int row : kept)
      part[row] = 1;
    std::vector<int> order(view.nrow);
    cholmod_camd(&view, nullptr, 0, part.data(), order.data(), &common);
    factors = cholmod_analyze_p(&view, order.data(), nullptr, 0, &common);
    cholmod_factorize(&view, factors, &common);
  }
  ~OrderedFactors()
  {
    cholmod_free_factor(&factors, &common);
    cholmod_finish(&common);
  }
  OrderedFactors(const OrderedFactors &) = delete;
  OrderedFactors &operator=(const OrderedFactors &) = delete;

  bool are_complete() const { return common.status == CHOLMOD_OK && factors->minor == factors->n; }

  /// Place of every row in the order of elimination.
  std::vector<int> places() const
  {
    std::vector<int> result(factors->n);
    for (std::size_t i = 0; i < factors->n; ++i)
      result[static_cast<std::size_t>(static_cast<const int *>(factors->Perm)[i])] = static_cast<int>(i);
    return result;
  }

  /// The last @p n rows and columns of L.
  Eigen::MatrixXd end(Eigen::Index n) const
  {
    const auto *starts = static_cast<const int *>(factors->p);
    const auto *lengths = static_cast<const int *>(factors->nz);
    const auto *rows = static_cast<const int *>(factors->i);
    const auto *values = static_cast<const double *>(factors->x);
    const Eigen::Index first = static_cast<Eigen::Index>(factors->n) - n;
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero(n, n);
    for (Eigen::Index j = 0; j < n; ++j)
      for (int k = starts[first + j]; k < starts[first + j] + lengths[first + j]; ++k)
        result(rows[k] - first, j) = values[k];
    return result;
  }

private:
  cholmod_common common = {};
  cholmod_factor *factors = nullptr;
};

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
    throw_indefinite();
}

SparseCholesky::~SparseCholesky() = default;

Eigen::MatrixXd SparseCholesky::solve(const Eigen::MatrixXd &right_hand_sides) const
{
  return factors->solve(right_hand_sides);
}

Eigen::MatrixXd inverse_block(const dealii::SparseMatrix<double> &matrix,
                              const std::vector<unsigned int> &kept, unsigned int n_columns)
{
  const OrderedFactors factors(lower_triangle_of(matrix), kept);
  if (!factors.are_complete())
    throw_indefinite();
  // With the kept rows last, (L L')^-1 has (L_e L_e')^-1 in their rows and columns, L_e the end of L.
  const auto n_kept = static_cast<Eigen::Index>(kept.size());
  const Eigen::MatrixXd end = factors.end(n_kept);
  const std::vector<int> places = factors.places();
  const Eigen::Index first = static_cast<Eigen::Index>(matrix.m()) - n_kept;
  Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(n_kept, n_columns);
  for (unsigned int j = 0; j < n_columns; ++j)
    columns(places[kept[j]] - first, j) = 1;
  end.triangularView<Eigen::Lower>().solveInPlace(columns);
  end.triangularView<Eigen::Lower>().transpose().solveInPlace(columns);
  Eigen::MatrixXd result(n_kept, n_columns);
  for (Eigen::Index i = 0; i < n_kept; ++i)
    result.row(i) = columns.row(places[kept[static_cast<std::size_t>(i)]] - first);
  return result;
}

} // namespace stemware::fem
